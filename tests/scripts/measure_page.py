"""Judges the report of `measure` as a browser left it (chromium --dump-dom): prints what is wrong; exit status 1 if anything is.

measure_page.py DOM STONES   STONES: how many the map must show; lines with the word CONSOLE after the page are errors that the browser told
"""
import html.parser
import re
import sys

# id: marks at least
PLOTS = {"large": 20, "ring": 10, "turns": 5, "ratios": 3, "counts": 20, "edge_angles": 2,
         "alignment-0": 4, "joints-0": 2, "areas-0": 4}
LOADING = {"src", "srcset", "data", "poster", "action", "background"}


class Page(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.faults = []
        self.depth = 0  # of elements within the plot that is being read
        self.plot = None
        self.marks = {name: 0 for name in PLOTS}
        self.drawn = set()
        self.style = False
        self.map = None  # id of the map that is being read
        self.map_stones = {}

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        for name, value in given.items():
            loads = name in LOADING or (name in ("href", "xlink:href") and tag != "a")
            if loads and not (value or "").startswith(("#", "data:")):
                self.faults.append(f"<{tag} {name}={value!r}> loads something")
        self.style = tag == "style"
        self.look_at_map(tag, given)
        if self.plot is None and (given.get("id") or "").startswith("plot-"):
            self.plot, self.depth = given["id"][len("plot-"):], 1
            if "failed" in (given.get("class") or ""):
                self.faults.append(f"the plot {self.plot} failed")
        elif self.plot is not None:
            self.depth += tag == "div"
            self.drawn.update([self.plot] if tag == "svg" else [])
            # Vega marks are paths with a role; a path without extent was not drawn.
            is_mark = tag == "path" and given.get("aria-roledescription") and len(given.get("d") or "") > 5
            self.marks[self.plot] += bool(is_mark)

    # A map tells how many stones it has drawn, and the probe of measure_test.sh how much of its canvas is coloured.
    def look_at_map(self, tag, given):
        if tag == "figure":
            self.map = given.get("id") if "map" in (given.get("class") or "").split() else None
            if self.map and "failed" in given["class"]:
                self.faults.append(f"the {self.map} failed")
        elif tag == "canvas" and self.map:
            self.map_stones[self.map] = (int(given.get("data-stones") or 0), float(given.get("data-ink") or 0))

    def handle_endtag(self, tag):
        if tag == "style":
            self.style = False
        if self.plot is not None and tag == "div":
            self.depth -= 1
            if self.depth == 0:
                self.plot = None

    def handle_data(self, text):
        if self.style and re.search(r"@import|url\(", text):
            self.faults.append("the style loads something")


def main():
    text = open(sys.argv[1], encoding="utf-8").read()
    page = Page()
    page.feed(text)
    for name, least in PLOTS.items():
        if name not in page.drawn:
            page.faults.append(f"the plot {name} is missing")
        elif page.marks[name] < least:
            page.faults.append(f"the plot {name}: expected {least} marks or more, got {page.marks[name]}")
    page.faults += [line for line in text[text.rfind("</html>"):].splitlines() if "CONSOLE" in line]
    if len(re.findall(r'<span class="verdict (?:holds|fails|open)">', text)) != 19 + 17:
        page.faults.append("expected 19 findings of panes and 17 of a pavement, with a verdict")
    stones, ink = page.map_stones.get("map-0", (0, 0))
    if stones != int(sys.argv[2]):
        page.faults.append(f"the map: expected {sys.argv[2]} stones, got {stones}")
    if ink < 0.5:
        page.faults.append(f"the map: expected stones over half of it or more, got {ink}")
    if text.count("<figure><svg") != 12:
        page.faults.append("expected drawings of 12 panes")
    print("\n".join(page.faults), end="\n" if page.faults else "")
    return 1 if page.faults else 0


sys.exit(main())
