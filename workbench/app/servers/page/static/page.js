// The page: asks the server for verdicts on what stands in the editor, and shows them.
import { showAssumptions, showDisplays } from "./displays.js";
import { createEditor } from "./editor.js";
import { GRADE_OF, button, counted, make, sign } from "./marks.js";

const PAUSE = 60, LOOK = 2000, SOON = 60, SLOW = 600;
const EXAMPLES = [
  ["Cross product, wrong order", "The product of vectors $\\mathbf{a}$ and $\\mathbf{b}$ is\n\\begin{equation}\n  \\mathbf{a} \\times \\mathbf{b} = \\mathbf{b} \\times \\mathbf{a} .\n\\end{equation}\n"],
  ["Square of a skew matrix", "For a vector $\\mathbf{a}$ with the skew matrix $[\\mathbf{a}]_\\times$,\n\\begin{equation}\n  [\\mathbf{a}]_\\times^2 = \\mathbf{a} \\mathbf{a}^T - (\\mathbf{a} \\cdot \\mathbf{a}) \\mathbf{I} .\n\\end{equation}\n"],
  ["A rotating vector", "Let $\\boldsymbol{\\omega}$ and $\\mathbf{r}$ be vectors with\n\\begin{align}\n  \\dot{\\mathbf{r}} &= \\boldsymbol{\\omega} \\times \\mathbf{r} , \\\\\n  \\ddot{\\mathbf{r}} &= \\dot{\\boldsymbol{\\omega}} \\times \\mathbf{r} - \\boldsymbol{\\omega} \\times (\\boldsymbol{\\omega} \\times \\mathbf{r}) .\n\\end{align}\n"],
];

const at = id => document.getElementById(id);
const tab = crypto.randomUUID();
const state = { document: "scratch", name: null, names: [], stamp: null, saved: "", answers: [], model: null, number: 0, judgedAt: null };

const given = new URLSearchParams(location.hash.slice(1)).get("token");
if (given) {
  sessionStorage.setItem("token", given);
  history.replaceState(null, "", location.pathname);
}
const token = sessionStorage.getItem("token") ?? "";

async function call(name, data = {}) {
  let answer;
  try {
    answer = await fetch(`api/${name}`, {
      method: "POST",
      headers: { "Content-Type": "application/json", "X-Workbench-Token": token },
      body: JSON.stringify({ tab, document: state.document, name: state.name, ...data }),
    });
  } catch {
    stopped();
    throw new Error("stopped");
  }
  const told = await answer.json().catch(() => ({ error: `the server answered ${answer.status}` }));
  if (answer.status === 409 && told.error === "superseded") throw new Error("superseded");
  if (!answer.ok) {
    alert(told.error);
    throw new Error(told.error);
  }
  return told;
}

const isQuiet = error => ["stopped", "superseded"].includes(error.message);

function alert(message, ...buttons) {
  at("alert").replaceChildren(make("span", {}, message), ...buttons);
  at("alert").hidden = false;
}

const calm = () => { at("alert").hidden = true; };

function stopped() {
  const since = state.judgedAt ? ` These results are from ${state.judgedAt}.` : "";
  const command = `workbench serve${state.names.length > 1 ? " FOLDER" : state.name ? ` ${state.name}` : ""}`;
  alert(`The server has stopped.${since} Your text is kept in this tab. Start again: ${command}`, button("Reconnect", () => judge()));
  at("status").textContent = "not judged while the server is down";
}

const editor = createEditor(at("editor"), document.querySelector("meta[name=nonce]").content, changed);
let waiting = null;

function changed() {
  if (state.document === "scratch") sessionStorage.setItem("text", editor.text());
  at("save").disabled = editor.text() === state.saved;
  clearTimeout(waiting);
  waiting = setTimeout(judge, PAUSE);
}

async function judge() {
  const number = ++state.number;
  const text = editor.text();
  if (!text.trim()) return blank();
  const start = performance.now();
  const isNew = () => number === state.number;
  at("displays").setAttribute("aria-busy", "true");
  let told = 0, slow = null;
  const look = async () => {
    const { judged, news, view } = await call("progress", { number, told }).catch(() => ({}));
    if (!isNew() || slow === null) return;
    if (view) show(view, text, performance.now() - start);
    told = news ?? told;
    if (judged != null && performance.now() - start > SLOW) at("status").textContent = `Judging: ${judged} formulas done`;
    slow = setTimeout(look, SOON);
  };
  try {
    const asked = call("check", { text, answers: state.answers, number });
    slow = setTimeout(look, SOON);
    const view = await asked;
    if (!isNew()) return;
    slow = clearTimeout(slow) ?? null;
    calm();
    show(view, text, performance.now() - start);
    if (view.displays.some(each => ["error", "warning"].includes(each.grade))) {
      at("status").textContent += " · looking for corrections";
      const corrected = await call("corrections");
      if (isNew()) show(corrected, text, performance.now() - start);
    }
  } catch (error) {
    if (isNew() && !isQuiet(error)) at("status").textContent = "";
  } finally {
    slow = clearTimeout(slow) ?? null;
    if (isNew()) at("displays").removeAttribute("aria-busy");
  }
}

const act = { apply, answer, show: place => editor.show(place) };

function apply(edits) {
  if (editor.text() !== state.judgedText) return; // the places are those of another text
  editor.apply(edits);
}

function answer({ table, key, value }) {
  const others = state.answers.filter(each => each.table !== table || each.key !== key || table === "points");
  state.answers = [...others, { table, key, value }];
  judge();
}

function show(view, text, milliseconds) {
  if (editor.text() !== text) return; // it is judged anew in a moment
  state.judgedAt = new Date().toLocaleTimeString();
  state.judgedText = text;
  const counts = Object.entries(view.counts);
  at("counts").replaceChildren(...counts.map(([word, count]) => make("li", {}, sign(GRADE_OF[word] ?? "note"), ` ${counted(word, count)}`)));
  const displays = view.displays.length;
  const seconds = (milliseconds / 1000).toFixed(1);
  at("status").textContent = `${displays} display${displays === 1 ? "" : "s"} · ${seconds} s`;
  document.title = `${view.summary || "workbench"} · ${state.name ?? "workbench"}`;
  at("order").textContent = displays ? "most serious first" : "";
  showDisplays(at("displays"), view, act);
  showAssumptions(at("assumptions"), view, act);
  editor.tell(view.displays, view.findings);
  if (!view.drafted) at("assumptions").replaceChildren(make("li", { class: "soft" }, displays ? `What the symbols are stands in ${state.model ?? "the text"}.` : "Nothing yet."));
  at("model-foot").hidden = !view.drafted;
  at("model").textContent = state.document === "file" ? `Write to ${modelName()}` : "Download the model";
  at("report").disabled = !displays;
}

const modelName = () => (state.name ?? "text.tex").replace(/.*\//, "").replace(/\.[^.]*$/, ".toml");

function blank() {
  at("displays").removeAttribute("aria-busy");
  at("displays").replaceChildren(make("div", { class: "blank" },
    make("p", {}, "Paste a text with displayed formulas into Source. Each display is proved, or refuted with numbers, or the page says what it needs to know."),
    ...EXAMPLES.map(([name, text]) => make("button", { type: "button", class: "ex", onclick: () => { state.answers = []; editor.set(text); } }, make("b", {}, name)))));
  for (const id of ["counts", "assumptions"]) at(id).replaceChildren();
  editor.tell([], []);
  at("order").textContent = "";
  at("status").textContent = "Nothing to judge yet. Everything stays on this computer.";
  at("model-foot").hidden = true;
  at("report").disabled = true;
  document.title = "workbench";
}

function download(name, text, type) {
  const link = make("a", { href: URL.createObjectURL(new Blob([text], { type })), download: name });
  link.click();
  URL.revokeObjectURL(link.href);
}

const stays = () => state.document === "file" && editor.text() !== state.saved && !confirm(`Leave ${state.name} without saving it?`);

at("new").addEventListener("click", () => {
  if (stays()) return;
  Object.assign(state, { document: "scratch", name: null, stamp: null, answers: [], model: null });
  showName();
  at("save").hidden = true;
  editor.set("");
  selectTab("source");
  editor.focus();
});

at("report").addEventListener("click", async () => {
  const { name, html } = await call("report");
  download(name, html, "text/html");
});

at("model").addEventListener("click", async () => {
  const { name, model } = await call("model", { write: state.document === "file" });
  if (state.document !== "file") return download(name, model, "application/toml");
  Object.assign(state, { model: name, answers: [] });
  judge();
});

at("save").addEventListener("click", async () => {
  const text = editor.text();
  const { stamp } = await call("save", { text, stamp: state.stamp });
  Object.assign(state, { stamp, saved: text });
  at("save").disabled = editor.text() === text;
});

function showName() {
  at("name").textContent = state.name ?? "no file";
  at("name").hidden = state.names.length > 1;
  at("texts").hidden = state.names.length <= 1;
  const first = state.name ? [] : [make("option", { value: "" }, "no file")];
  at("texts").replaceChildren(...first, ...state.names.map(each => make("option", { value: each }, each)));
  at("texts").value = state.name ?? "";
}

at("texts").addEventListener("change", async () => {
  if (stays()) return showName();
  const opened = await call("text", { name: at("texts").value, stamp: null }).catch(() => null);
  if (opened == null) return showName();
  state.answers = [];
  calm();
  load(opened);
});

function load({ name, names, text, stamp, model, model_stamp: modelStamp }) {
  Object.assign(state, { document: "file", name, names, stamp, model, modelStamp, saved: text });
  showName();
  at("save").hidden = false;
  editor.set(text);
}

async function look() {
  if (state.document !== "file" || document.hidden) return;
  const found = await call("text", { stamp: state.stamp });
  if (found.name !== state.name) return; // another text was opened meanwhile
  if (found.model_stamp !== state.modelStamp) {
    Object.assign(state, { model: found.model, modelStamp: found.model_stamp, answers: [] });
    judge();
  }
  if (found.text == null || found.stamp === state.stamp) return;
  if (editor.text() === state.saved) load(found);
  else {
    alert(`${found.name} was changed by another program.`,
      button("Load it", () => { calm(); load(found); }),
      button("Keep mine", () => { calm(); Object.assign(state, { stamp: found.stamp, saved: found.text }); changed(); }));
  }
}

const TABS = ["displays", "source", "assumed"];

function selectTab(name) {
  document.body.dataset.tab = name;
  for (const each of TABS) {
    at(`t-${each}`).setAttribute("aria-selected", String(each === name));
    at(`t-${each}`).tabIndex = each === name ? 0 : -1;
  }
}

for (const [place, name] of TABS.entries()) {
  at(`t-${name}`).addEventListener("click", () => selectTab(name));
  at(`t-${name}`).addEventListener("keydown", event => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    const next = TABS[(place + step + TABS.length) % TABS.length];
    selectTab(next);
    at(`t-${next}`).focus();
  });
}

addEventListener("beforeunload", event => {
  if (state.document === "file" && editor.text() !== state.saved) event.preventDefault();
});

const found = await call("text").catch(() => ({ name: null }));
if (found.text != null) load(found);
else editor.set(sessionStorage.getItem("text") ?? "");
setInterval(() => look().catch(() => {}), LOOK);
