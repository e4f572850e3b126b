#!/usr/bin/env bash
# Plans as DXF: drawings that ezdxf has made, of every version and kind of entity, are as large as ezdxf says; broken ones are refused in
# words; and the command starts as quickly as without GDAL.
#   dxf_test.sh BUILD   the build folder, in which ezdxf is installed
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"
python=$(python_tools ezdxf ezdxf==1.4.3)
"$python" "$here/dxf_files.py" "$scratch" 2>"$scratch/told"  # ezdxf says there that R12 has no units

"$python" - "$build/shatterpave" "$scratch" <<'PYTHON'
import json
import subprocess
import sys

program, folder = sys.argv[1:]
failed = []

def area(points):
    return abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(points, points[1:] + points[:1]))) / 2e6

with open(f"{folder}/expected.json", encoding="utf-8") as file:
    expected = json.load(file)
for name, areas in expected.items():
    run = subprocess.run([program, "export", f"{folder}/{name}.toml", "-o", f"{folder}/out", "--target", "json"],
                         capture_output=True, text=True)
    if areas is None:
        told = run.stderr.strip()
        if run.returncode != 2 or "\n" in told or "expected" not in told or f"{name}.dxf" not in told:
            failed.append(f"{name}: status {run.returncode}: {told}")
        continue
    if name == "fit_points" and "left out one or more" not in run.stderr:
        failed.append(f"{name}: no word of the spline that is left out: {run.stderr}")
    if run.returncode != 0:
        failed.append(f"{name}: {run.stderr}")
        continue
    with open(f"{folder}/out/{name}.json", encoding="utf-8") as file:
        pavements = json.load(file)["pavements"]
    found = sorted(area(p["outline_mm"]) - sum(map(area, p["holes_mm"])) for p in pavements)
    # Curves as lines: of arcs 0.02 % of their area at most; GDAL makes eight of a spline for each of its control points.
    part = 4e-3 if name == "spline" else 3e-4
    if len(found) != len(areas) or any(abs(a - b) > part * b for a, b in zip(found, sorted(areas))):
        failed.append(f"{name}: expected {areas} m², got {found}")
if failed:
    sys.exit("\n".join(failed))
print(f"dxf: {len(expected)} drawings")
PYTHON

# Without what the scene says of units they are refused.
sed -i '/outline_units/d' "$scratch/no_units.toml"
refuses 'no_units.dxf: expected a drawing that tells its units' shatterpave check "$scratch/no_units.toml"
# GDAL is opened where a DXF is read, and nowhere else.
libraries() { LD_DEBUG=files "$build/shatterpave" check "$1" 2>&1 >/dev/null | grep -c 'calling init:.*libgdal' || true; }
printf '[[pavement]]\nname = "yard"\nsize_mm = [1000, 1000]\nstone_mm = [100, 100]\n' >"$scratch/plain.toml"
[[ $(libraries "$scratch/plain.toml") == 0 ]] || fail "GDAL is loaded for a scene without a plan"
[[ $(libraries "$scratch/grid.toml") == 1 ]] || fail "GDAL is not seen to be loaded for a DXF"
