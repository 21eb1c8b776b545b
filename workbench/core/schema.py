"""Keys of paper files and models: type, meaning, example. Used by the loader, the guide and completion."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Key:
    """A key that a table may have.

    type: in words, as "text" or "list of texts".   choices: the allowed values, if there are few.
    """

    name: str
    type: str
    meaning: str
    example: str = ""
    choices: tuple[str, ...] = ()


#: Keys at the top of every file: of papers, models and notation files.
_NOTATION = (
    Key("title", "text", "The title of the paper; a paper file needs one.", 'title = "My paper"'),
    Key("doi", "text", "Its DOI."),
    Key("notation", "text or table", "Spellings of the author's own, or the file that this one stands on."),
    Key("conventions", "table", "Readings of notation on which authors differ."),
    Key("symbols", "table", "What each symbol is.", "symbols.'r' = \"vector\""),
    Key(
        "definitions",
        "table",
        "What each defined symbol stands for, in order.",
        "definitions.'v' = '\\dot{r}'",
    ),
    Key(
        "motion",
        "table",
        "Which quantity of a simulated motion each symbol is.",
        "motion.'\\omega' = \"w_WB\"",
    ),
    Key("frames", "table", "Frames of reference and the spellings that name them."),
    Key("points", "table", "Points and the spellings that name them."),
    Key("budget", "table", "Limits on time and memory for each judgement.", "budget = { seconds = 60 }"),
)

_FORMULAS = (
    Key("printed", "text", "What is printed: a formula, or a sentence in “ ”.", "printed = 'a = b'"),
    Key("reading", "text", "The intended formula, where the printed one is ill-formed."),
    Key("corrected", "text", "The right formula, where the printed one is false."),
    Key("hypothesis", "text", "A condition that the text does not state."),
    Key(
        "assume",
        "list of texts",
        "Conditions that the text states, as = or \\neq.",
        "assume = ['\\omega \\neq 0']",
    ),
    Key("orders", "text", "The values of the indices that are meant.", 'orders = "n = 1..8"'),
    Key("inherits", "list of texts", "Earlier claims whose error this one repeats.", "inherits = ['67.w']"),
    Key("note", "text", "A remark for readers of the file."),
)

_MEND = (
    Key("fault", "text", "error, misprint, transcription, wording or hypothesis.", 'fault = "misprint"'),
    Key("mend", "list of pairs", "For the first text read the second.", "mend = [['n!', 'k!']]"),
    Key("mended_by", "text", "The claim whose correction corrects this one, too.", 'mended_by = "67.w"'),
    Key("beside", "text", "The sentence or formula beside the claim to which the edit belongs."),
    Key("place", "text", "Where in the equation the fault is.", 'place = "second line"'),
    Key("cause", "text", "The common cause of several faults: a heading in the erratum note."),
    Key("add", "text", "A missing hypothesis in the author's words."),
    Key("example", "text", "A counterexample in words."),
)

SCHEMA: dict[str, tuple[Key, ...]] = {
    "paper file": (
        *_NOTATION,
        Key("citation", "table", "Source and licence of the paper."),
        Key("section", "text", "The section of the claims that name none.", 'section = "4.1"'),
        Key("sections", "table", "The headings of sections by their numbers."),
        Key("claim", "tables", "The claims, in reading order."),
    ),
    "notation file": _NOTATION,
    "model": (
        *_NOTATION,
        Key("source", "text", "The text that the model belongs to.", 'source = "paper.tex"'),
        Key("macros", "text or table", "Macros that stand elsewhere.", 'macros = "site.tex"'),
        Key("scope", "tables", "Declarations that hold from a place on."),
        Key("claim", "tables", "What the text does not say of a display."),
        Key("guessed", "list of texts", "Symbols and tables that nobody confirmed.", "guessed = ['m']"),
        Key("citation", "table", "Source and licence of the paper."),
    ),
    "directive": (
        *(
            key
            for key in _NOTATION
            if key.name in ("title", "doi", "conventions", "symbols", "definitions", "motion")
        ),
    ),
    "symbol": (
        Key("kind", "text", "scalar, vector, tensor, rotation, …; see the page on kinds.", 'kind = "vector"'),
        Key("weight", "number", "The power of 1/time in its dimension.", "weight = 1"),
        Key("constant", "boolean", "Its derivative by the time is 0."),
        Key("unit", "boolean", "Its norm is 1 (vector, hamilton quaternion)."),
        Key("coordinate", "boolean", "The position of a field: div and curl differentiate by it."),
        Key("uniform", "boolean", "The same at every position, so that ∇ of it is 0."),
        Key("independent", "boolean", "A coordinate that ∂/∂x of another coordinate keeps fixed."),
        Key("symmetric", "boolean", "A symmetric tensor."),
        Key("diagonal", "boolean", "A diagonal tensor."),
        Key("small", "boolean", "Small of first order: a \\approx b drops its products."),
        Key("positive", "boolean", "A scalar above 0: roots are taken of it and it divides."),
        Key("free", "boolean", "Any value, whatever the text seems to say of it."),
        Key("of", "list of texts", "The symbols of which it is a function.", "of = ['q', 't']"),
        Key("aliases", "list of texts", "Other spellings of it.", "aliases = ['\\vec{r}']"),
        Key("note", "text", "A remark for readers of the file."),
    ),
    "notation entry": (
        Key("where", "table", "The kind of each formal argument.", 'where = { x = "vector" }'),
        Key("means", "text", "The meaning in known notation.", "means = '\\operatorname{skew}(x)'"),
    ),
    "conventions": (
        Key(
            "quaternion",
            "text",
            "Product and order of quaternions.",
            'quaternion = "hamilton, scalar first"',
            ("hamilton, scalar first",),
        ),
        Key(
            "gradient",
            "text",
            "How ∂(scalar)/∂x stands: row or column.",
            'gradient = "row"',
            ("row", "column"),
        ),
        Key(
            "points",
            "text",
            "What T p is: homogeneous (four components) or vectors (R p + t).",
            'points = "vectors"',
            ("homogeneous", "vectors"),
        ),
        Key(
            "products",
            "text",
            "a b of vectors: dyads, or matrices (never a dyad).",
            'products = "dyads"',
            ("dyads", "matrices"),
        ),
        Key(
            "one",
            "text",
            "A number beside tensors: unit (a multiple of the unit tensor) or scalar.",
            'one = "unit"',
            ("unit", "scalar"),
        ),
        Key("powers", "text", "\\sin(x)^2 is (\\sin x)^2.", 'powers = "values"', ("values",)),
        Key(
            "cross",
            "text",
            "a \\times b \\times c is a \\times (b \\times c).",
            'cross = "right"',
            ("right",),
        ),
        Key("brackets", "text", "k (x) is the product k x.", 'brackets = "factors"', ("factors",)),
        Key("letters", "text", "A hat, an I or a letter says nothing.", 'letters = "none"', ("none",)),
        Key("arguments", "list of texts", "Brackets that are arguments.", "arguments = ['\\mathbf{q}']"),
        Key(
            "functions",
            "list of texts",
            "Functions that are written without a backslash.",
            'functions = ["cos"]',
        ),
    ),
    "frames": (
        Key("base", "text", "The frame in which the others move.", 'base = "N"'),
        Key("names", "list of texts", "The other frames.", 'names = ["A", "B"]'),
        Key(
            "axes",
            "table",
            "The axes of each frame.",
            "axes = { B = ['\\hat{b}_x', '\\hat{b}_y', '\\hat{b}_z'] }",
        ),
        Key("dot", "text", "The frame in which a dot differentiates vectors.", 'dot = "N"'),
        Key("rates", "text", "What {}^B\\dot{v} is: resolved, or of components.", 'rates = "resolved"'),
        Key(
            "orientation",
            "table",
            "The rotation matrix of a frame, or its axes.",
            "orientation = { A = 'R' }",
        ),
    ),
    "points": (
        Key("names", "list of texts", "The points.", 'names = ["O", "P"]'),
        Key("fixed", "table", "The frames in which a point is fixed.", 'fixed = { O = ["N"] }'),
        Key(
            "place",
            "table",
            "The position of a point from another.",
            "place = { P = [\"O\", 'l \\hat{b}_x'] }",
        ),
    ),
    "motion robot": (
        Key("urdf", "text", "A URDF file beside the paper file.", 'urdf = "arm.urdf"'),
        Key("body", "text", "The body that moves.", 'body = "tool"'),
    ),
    "motion claim": (
        Key("holds", "text", "A formula that holds if the claim does."),
        Key("printed", "text", "A formula that is false if the claim is false as printed."),
        Key("orders", "text", "The values of its indices.", 'orders = "n = 1..3"'),
        Key("on", "text", "The special motion on which it is evaluated."),
        Key("none", "text", "Why no motion tests the claim.", 'none = "algebra"'),
    ),
    "budget": (
        Key("seconds", "number", "Processor time for each judgement.", "seconds = 60"),
        Key("megabytes", "number", "Memory for each judgement.", "megabytes = 2000"),
    ),
    "citation": (
        Key("authors", "text", "The authors."),
        Key("source", "text", "Where the paper stands."),
        Key("year", "text", "The year."),
        Key("pages", "text", "The pages."),
        Key("commit", "text", "The commit of the file that was read."),
        Key("licence", "text", "The licence."),
        Key("read", "text", "What was read: a scan, a transcription, the source."),
        Key("recheck", "text", "The command by which a reader checks the note."),
    ),
    "claim of a paper file": (
        Key("id", "text", "The name of the claim: letters, digits and . _ - + * '.", 'id = "58.det"'),
        Key("equation", "text", "The number of the equation.", 'equation = "58"'),
        Key("section", "text", "The section.", 'section = "4.1"'),
        *_FORMULAS,
        Key("formula", "text", "Our formula for a printed sentence."),
        Key("goal", "text", "A statement with quantifiers that the sentence means."),
        Key("statement", "text", "What a sentence claims, in words."),
        Key("theorem", "text", "The registered proof of the goal."),
        Key("argued", "text", "What joins the goal to the sentence, where no rule does."),
        Key("every_n", "text", "The registered proof for every n."),
        *_MEND,
    ),
    "claim of a model": (
        Key("at", "text or list", 'The display: a label, a number, an id or "line 20".', 'at = "eq:lag"'),
        *_FORMULAS,
        Key("given", "list of texts", "The formulas before it from which it follows.", 'given = ["eq:law"]'),
        Key("skip", "text", "Why the display is left out.", 'skip = "a figure of speech"'),
        Key("unread", "text", "Why no verdict is expected yet."),
        *_MEND,
    ),
    "scope": (
        Key("from", "text", "Where it begins: a label, number, section or line.", 'from = "2"'),
        *(key for key in _NOTATION if key.name in ("symbols", "definitions", "motion", "frames", "points")),
    ),
}


def key_names(table: str) -> tuple[str, ...]:
    """Returns the names of the keys that the table may have."""
    return tuple(key.name for key in SCHEMA[table])


def flag_names() -> tuple[str, ...]:
    """Returns the boolean keys of a symbol."""
    return tuple(key.name for key in SCHEMA["symbol"] if key.type == "boolean")


def choices(table: str) -> dict[str, tuple[str, ...]]:
    """Returns the keys of the table that have a fixed set of values, with these values."""
    return {key.name: key.choices for key in SCHEMA[table] if key.choices}
