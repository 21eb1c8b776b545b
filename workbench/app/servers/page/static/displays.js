// The displays with their verdicts, the questions of a draft, and what was assumed.
import { ORDER, button, make, sign } from "./marks.js";

const open = new Set();

export function showDisplays(parent, view, act) {
  const focused = document.activeElement?.dataset?.name;
  const rows = view.displays.map((each, at) => [each, at]);
  rows.sort(([a, i], [b, j]) => ORDER.indexOf(a.grade) - ORDER.indexOf(b.grade) || i - j);
  const faults = view.faults.length && make("ul", { class: "faults", "aria-label": "What of the text cannot be used" }, ...view.faults.map(each => make("li", {}, each)));
  const list = make("ol", { "aria-label": "Displays" }, ...rows.map(([each]) => display(each, act)));
  parent.replaceChildren(...[faults, questions(view, act), list].filter(Boolean));
  if (focused) parent.querySelector(`[data-name="${CSS.escape(focused)}"]`)?.focus();
}

function display(each, act) {
  const [item] = each.items;
  const isOpen = open.has(each.name);
  const body = make("div", { class: "body", hidden: !isOpen });
  const head = make("button", { type: "button", class: "head", "data-name": each.name, "aria-expanded": String(isOpen), "aria-label": `${each.name}: ${each.word}` },
    sign(each.grade),
    make("span", {}, make("span", { class: "num" }, each.name), each.file ? make("span", { class: "soft" }, ` in ${each.file}`) : null),
    make("span", { class: "word" }, each.word));
  const toggle = wanted => {
    head.setAttribute("aria-expanded", String(wanted));
    body.hidden = !wanted;
    if (wanted) { open.add(each.name); fill(body, each); } else open.delete(each.name);
    if (wanted && each.place) act.show(each.place);
  };
  head.addEventListener("click", () => toggle(body.hidden));
  head.addEventListener("keydown", event => {
    if (event.key === "Escape") toggle(false);
    else if (event.key === "ArrowDown" || event.key === "ArrowUp") neighbour(head, event.key === "ArrowDown");
    else if (event.key.toLowerCase() === "a" && !event.ctrlKey && !event.metaKey && item?.edits.length) act.apply(item.edits);
    else return;
    event.preventDefault();
  });
  if (isOpen) fill(body, each);
  const formulas = make("div", { class: "f", tabindex: "-1" }, ...each.formulas.map(one =>
    make("div", { class: ["error", "warning"].includes(one.grade) && each.formulas.length > 1 ? "bad" : null, html: one.html })));
  const told = each.items.length ? each.items.map(one => short(one, act))
    : each.remark ? [make("p", { class: "soft", html: each.remark })] : [];
  return make("li", { class: "d" }, head, make("div", { class: "body" }, formulas, ...told), body);
}

function neighbour(head, forward) {
  const all = [...document.querySelectorAll("#displays .head")];
  all[all.indexOf(head) + (forward ? 1 : -1)]?.focus();
}

function short(item, act) {
  const told = make("div", {}, make("p", { class: "what", html: item.what }));
  if (item.unless.length) told.append(make("p", { class: "soft", html: `unless ${item.unless.join("; ")}` }));
  if (item.diff.length) told.append(make("pre", {}, ...item.diff.flatMap(changed)));
  if (item.proposal) told.append(make("p", {}, "Right: ", make("span", { html: item.proposal })));
  if (item.proved) told.append(make("p", { class: "soft" }, "The corrected formula is proved."));
  if (item.edits.length) told.append(make("p", { class: "act" }, button("Apply", () => act.apply(item.edits), "first")));
  return told;
}

function changed({ line, parts }) {
  const half = (name, mark, kind) => make("span", { class: name }, `${line} ${mark} `,
    ...parts.filter(([what]) => what === "same" || what === kind).map(([what, text]) => (what === "same" ? text : make(what, {}, text))));
  return [half("gone", "−", "del"), half("new", "+", "ins")];
}

function fill(body, each) {
  if (body.childElementCount) return;
  const rows = [];
  const row = (name, html) => { if (html) rows.push(make("dt", {}, name), make("dd", { html })); };
  for (const { example } of each.items) {
    if (example) row("Counterexample", `${example.with ? `${example.with}: ` : ""}left side ${example.left}, right side ${example.right}`);
  }
  for (const one of each.details) {
    if (each.details.length > 1) rows.push(make("dt", {}, "Formula"), make("dd", {}, make("code", {}, one.id)));
    row("How it was read", one.read);
    row("Holds if", one.holds_if);
    row("Why", one.because);
    rows.push(make("dt", {}, "Verdict"), make("dd", {}, `${one.verdict}, on what is ${one.basis}`));
    if (one.code) rows.push(make("dt", {}, "Explained by"), make("dd", {}, make("code", {}, `workbench help ${one.code}`)));
    if (one.evidence.length) rows.push(make("dt", {}, "Rests on"), make("dd", {}, ...one.evidence.map(line => make("div", {}, line))));
  }
  body.append(make("dl", {}, ...rows));
}

function questions(view, act) {
  if (!view.questions.length) return null;
  return make("ul", { "aria-label": "Questions" }, ...view.questions.map(each => make("li", { class: "d" },
    make("p", { class: "what" }, sign("not judged"), ` ${each.text} `,
      make("small", {}, `line ${each.line}; decides ${each.settles} formula${each.settles === 1 ? "" : "s"}`)),
    make("p", { class: "act" }, ...each.answers.map(answer => make("button", { type: "button", title: answer.lines, onclick: () => act.answer(answer) },
      answer.table === "symbols" ? JSON.parse(answer.value) : answer.lines))))));
}

export function showAssumptions(parent, view, act) {
  const focused = document.activeElement?.dataset?.symbol;
  const rows = view.assumptions.map(each => make("li", {},
    make("div", { class: "a1" }, make("span", { class: "sym", html: each.symbol }),
      make("select", { "aria-label": `Kind of ${each.label}`, "data-symbol": each.key, onchange: event =>
        act.answer({ table: "symbols", key: each.key, value: JSON.stringify(event.target.value) }) },
      ...each.choices.map(kind => make("option", { selected: kind === each.kind }, kind)))),
    make("div", { class: "a2" }, make("span", { class: `b ${each.basis}` }, each.basis),
      make("span", {}, [...each.flags, each.why].filter(Boolean).join(", ")))));
  parent.replaceChildren(...rows);
  if (focused) parent.querySelector(`[data-symbol="${CSS.escape(focused)}"]`)?.focus();
}
