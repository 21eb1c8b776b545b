"""Table of the commands by group: target, summary and examples of each. Imports no command."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Entry:
    """One command of the command line.

    Attributes:
        target: "module:object".
        summary: At most 65 characters, so that it is not cut at 80 columns.
        examples: Complete command lines.
        hidden: Whether it is an old name, which no list shows.
    """

    group: str
    name: str
    target: str
    summary: str
    examples: tuple[str, ...]
    hidden: bool = False


COMMANDS = (
    Entry(
        "Check",
        "check",
        "workbench.app.commands.check:check",
        "Check papers and texts, and print what is wrong.",
        ("workbench check paper.tex", "workbench check paper.toml --format github"),
    ),
    Entry(
        "Check",
        "bisect",
        "workbench.app.commands.bisect:bisect",
        "Find the git commit since which each display is false.",
        ("workbench bisect paper.tex", "workbench bisect paper.tex --most 20"),
    ),
    Entry(
        "Check",
        "draft",
        "workbench.app.commands.draft_command:draft_text",
        "Write a first model beside a text.",
        ("workbench draft paper.tex", "workbench draft paper.tex --macros site.tex --force"),
    ),
    Entry(
        "Check",
        "ingest",
        "workbench.app.commands.draft_command:draft_text",
        "The old name of draft.",
        ("workbench draft paper.tex",),
        hidden=True,
    ),
    Entry(
        "Check",
        "try",
        "workbench.app.commands.try_formula:try_formula",
        "Judge one formula.",
        (r"workbench try 'a \times b = b \times a' -s a=vector -s b=vector",),
    ),
    Entry(
        "Check",
        "init",
        "workbench.app.commands.init:init",
        "Write a paper file to begin with.",
        ("workbench init paper.toml",),
    ),
    Entry(
        "Check",
        "serve",
        "workbench.app.commands.serve:serve",
        "Show a page that judges a text as you type (extra page).",
        ("workbench serve", "workbench serve paper.tex --open"),
    ),
    Entry(
        "Check",
        "lsp",
        "workbench.app.servers.lsp:lsp",
        "Serve an editor: verdicts as you type (extra lsp).",
        ("workbench lsp",),
    ),
    Entry(
        "Check",
        "mcp",
        "workbench.app.servers.mcp:mcp",
        "Serve an assistant by the Model Context Protocol (extra mcp).",
        ("workbench mcp",),
    ),
    Entry(
        "Read",
        "report",
        "workbench.app.commands.commands:report",
        "Write the report of a paper: HTML, JSON, Markdown, LaTeX.",
        ("workbench report", "workbench report --paper kindr --out kindr-report"),
    ),
    Entry(
        "Read",
        "show",
        "workbench.app.commands.commands:show",
        "Show one claim in full.",
        ("workbench show 70.div", "workbench show 58.det --paper chapter --json"),
    ),
    Entry(
        "Read",
        "list",
        "workbench.app.commands.commands:list_claims",
        "List the claims of a paper without judging them.",
        ("workbench list", "workbench list 45-70 --paper chapter"),
    ),
    Entry(
        "Read",
        "help",
        "workbench.app.commands.help:help_command",
        "Show a page of the manual, or the meaning of a code.",
        ("workbench help", "workbench help frames", "workbench help --search quaternion"),
    ),
    Entry(
        "Robot",
        "motion",
        "workbench.app.commands.motion_command:motion",
        "Print twists, accelerations and jerk of a robot's body.",
        (
            "workbench motion robot.urdf --body hand --order 4",
            "workbench motion arm.urdf --body hand --trajectory q.csv --limits limits.toml",
        ),
    ),
    Entry(
        "Chapter",
        "verify",
        "workbench.app.commands.commands:verify",
        "Judge claims and compare the verdicts with the recorded ones.",
        ("workbench verify 45-70", "workbench verify '58.*'"),
    ),
    Entry(
        "Chapter",
        "errata",
        "workbench.app.commands.repair_commands:errata",
        "Compare proposed corrections with the known errata.",
        ("workbench errata 70",),
    ),
    Entry(
        "Chapter",
        "repair",
        "workbench.app.commands.repair_commands:repair_claim",
        "Propose the right form of claims.",
        ("workbench repair 70.div",),
    ),
    Entry(
        "Chapter",
        "certify",
        "workbench.app.commands.certify_command:certify",
        "Write exact claims as theorems of Coq, and check them.",
        ("workbench certify 58 --out certificates", "workbench certify --check"),
    ),
)
