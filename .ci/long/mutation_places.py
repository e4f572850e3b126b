"""The places of a source where a mutant can be, by libclang: what .ci/long/mutations draws from."""
import collections
import re
import shlex
import subprocess

from clang import cindex

Place = collections.namedtuple("Place", "file line begin end text told")

OPPOSITES = {"+": "-", "-": "+", "*": "/", "/": "*", "<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "&&": "||",
             "||": "&&", "+=": "-=", "-=": "+=", "*=": "/=", "/=": "*="}


class Finder:
    """All places of a source, by its bytes. A place's text has @ where the question is to stand whether its mutant is alive."""

    def __init__(self, source, name, arguments):
        self.kinds = cindex.CursorKind
        self.array = cindex.TypeKind.CONSTANTARRAY
        self.source = str(source)
        self.name = name
        self.bytes = source.read_bytes()
        self.places = {}
        self.macros = []
        unit = cindex.Index.create().parse(self.source, arguments, options=cindex.TranslationUnit.PARSE_DETAILED_PROCESSING_RECORD)
        for error in unit.diagnostics:
            if error.severity >= cindex.Diagnostic.Error and str(error.location.file) == self.source:
                print(f"{name}: {error.spelling}", flush=True)
        for cursor in unit.cursor.get_children():
            if cursor.location.file and cursor.location.file.name == self.source:
                if cursor.kind == self.kinds.MACRO_INSTANTIATION:
                    self.macros.append(self.range(cursor))
                elif not cursor.kind.is_preprocessing():
                    self.visit_declaration(cursor)

    def range(self, cursor):
        return cursor.extent.start.offset, cursor.extent.end.offset

    def text(self, begin, end):
        return self.bytes[begin:end].decode()

    def text_of(self, cursor):
        return self.text(*self.range(cursor))

    def found(self, cursor, text, words):
        begin, end = self.range(cursor)
        if begin < end and not any(b < end and begin < e for b, e in self.macros):
            line = cursor.extent.start.line
            self.places[begin, end, words] = Place(self.name, line, begin, end, text, " ".join(words.split()))

    def visit_declaration(self, cursor):
        """Only what stands in the bodies of functions that run with the program is looked at."""
        k = self.kinds
        functions = (k.FUNCTION_DECL, k.CXX_METHOD, k.CONSTRUCTOR, k.DESTRUCTOR, k.CONVERSION_FUNCTION, k.FUNCTION_TEMPLATE)
        for child in cursor.get_children():
            if cursor.kind in functions:
                before = self.text(cursor.extent.start.offset, child.extent.start.offset)
                if child.kind == k.COMPOUND_STMT and not re.search(r"\b(constexpr|consteval)\b", before):
                    self.visit(child)
            elif cursor.kind in (k.NAMESPACE, k.STRUCT_DECL, k.CLASS_DECL, k.CLASS_TEMPLATE, k.LINKAGE_SPEC, k.UNEXPOSED_DECL):
                self.visit_declaration(child)

    def visit(self, cursor):
        k = self.kinds
        children = list(cursor.get_children())
        if self.is_of_compile_time(cursor):
            return
        if cursor.kind in (k.BINARY_OPERATOR, k.COMPOUND_ASSIGNMENT_OPERATOR) and len(children) == 2:
            self.operator(cursor, children[0], children[1])
        elif cursor.kind == k.CALL_EXPR:
            self.call(cursor, children)
        elif cursor.kind in (k.IF_STMT, k.WHILE_STMT, k.CONDITIONAL_OPERATOR):
            self.condition(cursor, children)
        elif cursor.kind == k.INTEGER_LITERAL:
            self.integer(cursor)
        elif cursor.kind == k.FLOATING_LITERAL:
            self.floating(cursor)
        elif cursor.kind == k.COMPOUND_STMT:
            for child in children:
                self.statement(child)
        for child in self.running(cursor, children):
            self.visit(child)

    def is_of_compile_time(self, cursor):
        k = self.kinds
        if cursor.kind in (k.STATIC_ASSERT, k.PARM_DECL, k.TYPE_ALIAS_DECL, k.TYPEDEF_DECL, k.USING_DECLARATION, k.ENUM_DECL):
            return True
        if cursor.kind == k.DECL_STMT:
            return bool(re.match(r"(static\s+|inline\s+)*constexpr\b|static_assert\b", self.text_of(cursor)))
        return cursor.kind == k.IF_STMT and bool(re.match(r"if\s+constexpr\b", self.text_of(cursor)))

    def running(self, cursor, children):
        """The children that are no arguments of templates, sizes of arrays or labels."""
        k = self.kinds
        literals = (k.INTEGER_LITERAL, k.FLOATING_LITERAL)
        if cursor.kind == k.CASE_STMT:
            return children[1:]
        if cursor.kind in (k.DECL_REF_EXPR, k.MEMBER_REF_EXPR, k.OVERLOADED_DECL_REF, k.TYPE_REF, k.TEMPLATE_REF):
            return [c for c in children if c.kind not in literals]
        if cursor.kind == k.VAR_DECL:
            array = cursor.type.kind == self.array
            return [c for c in children if c.kind not in literals or (not array and c.extent.start.offset > cursor.location.offset)]
        return children

    def operator(self, cursor, left, right):
        end, begin = left.extent.end.offset, right.extent.start.offset
        word = re.sub(r"/\*.*?\*/|//[^\n]*|\s", "", self.text(end, begin)) if end < begin else ""
        if word in OPPOSITES and "basic_string" not in cursor.type.get_canonical().spelling:
            # In brackets of their own, or && for the second || of a || b || c would take b from a.
            whole, changed = self.text_of(cursor), f"({self.text_of(left)}) {OPPOSITES[word]} ({self.text_of(right)})"
            if left.extent.start.offset == cursor.extent.start.offset and right.extent.end.offset == cursor.extent.end.offset:
                self.found(cursor, f"(@ ? ({changed}) : ({whole}))", f"{whole} -> {OPPOSITES[word]}")

    def call(self, cursor, children):
        if re.match(r"operator\W+$", cursor.spelling):
            ends = sorted((c for c in children if not c.spelling.startswith("operator") or c.kind == self.kinds.CALL_EXPR
                           or c.kind.is_expression() and len(list(c.get_children())) > 1), key=lambda c: c.extent.start.offset)
            if len(ends) == 2:
                self.operator(cursor, *ends)
            return
        for argument in cursor.get_arguments():
            if argument is not None and re.fullmatch(r"([\w.]|->)*\bseed_?", self.text_of(argument)):
                name = self.text_of(argument)
                if argument.type.get_canonical().spelling.replace("const ", "") in ("unsigned long", "unsigned long long"):
                    self.found(argument, f"(@ ? 1UL : {name})", f"{self.text_of(cursor)[:60]}: {name} -> 1")

    def condition(self, cursor, children):
        """The first expression, unless it is a variable that is declared there."""
        declared = None
        for child in children:
            if child.kind in (self.kinds.DECL_STMT, self.kinds.VAR_DECL):
                declared = child
            elif child.kind.is_expression():
                text = self.text_of(child)
                if not declared or child.extent.start.offset >= declared.extent.end.offset:
                    self.found(child, f"(@ != static_cast<bool>({text}))", f"{text} -> not that")
                return
            elif declared is None:
                return

    def integer(self, cursor):
        text = self.text_of(cursor)
        if re.fullmatch(r"(0[xX][0-9a-fA-F']+|[0-9][0-9']*)[uUlLzZ]*", text):
            self.found(cursor, f"(@ ? {text} + 1 : {text})", f"{text} -> {text} + 1")

    def floating(self, cursor):
        text = self.text_of(cursor)
        number = re.fullmatch(r"([0-9.']+(?:[eE][-+]?[0-9]+)?)([fF]?)", text)
        if number:
            suffix = number[2]
            zero = float(number[1].replace("'", "")) == 0.0
            changed = f"1.0{suffix}" if zero else f"1.1{suffix} * {text}"
            self.found(cursor, f"(@ ? {changed} : {text})", f"{text} -> {changed}")

    def statement(self, cursor):
        """A call alone, but not one that only sets memory aside."""
        inner = cursor
        while inner.kind == self.kinds.UNEXPOSED_EXPR and len(list(inner.get_children())) == 1:
            inner = next(inner.get_children())
        if inner.kind == self.kinds.CALL_EXPR and not inner.spelling.startswith(("operator", "reserve")) and self.range(inner) == self.range(cursor):
            text = self.text_of(cursor)
            self.found(cursor, f"(@ ? void() : static_cast<void>({text}))", f"{text} -> left out")


def arguments_of(command):
    """What a compiler is told about a source that says how to read it. The headers of GCC's own are GCC's."""
    words = shlex.split(command)
    kept = []
    for word, following in zip(words, words[1:] + [""]):
        if word in ("-isystem", "-I"):
            kept += [word, following]
        elif re.match(r"-[DI].|-std=", word):
            kept.append(word)
    compiler = words[1] if "ccache" in words[0] else words[0]
    own = subprocess.run([compiler, "-print-file-name=include"], check=True, capture_output=True, text=True).stdout.strip()
    return ["-x", "c++", *kept, "-isystem", own]
