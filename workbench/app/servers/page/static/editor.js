// The author's text: CodeMirror with marks beside the displays and lines under what is wrong.
import {
  Decoration, EditorState, EditorView, GutterMarker, HighlightStyle, StateEffect, StateField, StreamLanguage,
  bracketMatching, defaultKeymap, drawSelection, gutter, highlightActiveLine, history, historyKeymap, keymap,
  lineNumbers, searchKeymap, setDiagnostics, stex, syntaxHighlighting, tags,
} from "./codemirror.js";
import { SIGNS, slug } from "./marks.js";

const colours = HighlightStyle.define([
  { tag: [tags.tagName, tags.keyword, tags.function(tags.variableName)], color: "var(--ok)" },
  { tag: tags.comment, color: "var(--soft)" },
]);

class Mark extends GutterMarker {
  constructor(grade, name) { super(); this.grade = grade; this.name = name; }
  eq(other) { return other.grade === this.grade && other.name === this.name; }
  toDOM() {
    const sign = document.createElement("span");
    sign.className = `k ${slug(this.grade)}`;
    sign.textContent = SIGNS[this.grade];
    sign.title = `${this.name}: ${this.grade}`;
    return sign;
  }
}

const setMarks = StateEffect.define();
const setShown = StateEffect.define();
const marks = StateField.define({
  create: () => [],
  update(value, change) {
    for (const effect of change.effects) if (effect.is(setMarks)) return effect.value;
    return change.docChanged ? value.map(each => ({ ...each, at: change.changes.mapPos(each.at) })) : value;
  },
});
const shown = StateField.define({
  create: () => Decoration.none,
  update(value, change) {
    for (const effect of change.effects) if (effect.is(setShown)) return effect.value;
    return value.map(change.changes);
  },
  provide: field => EditorView.decorations.from(field),
});

export function createEditor(parent, nonce, onChange) {
  const beside = gutter({
    class: "cm-marks",
    lineMarker(view, line) {
      const found = view.state.field(marks).find(each => line.from <= each.at && each.at <= line.to);
      return found ? new Mark(found.grade, found.name) : null;
    },
    lineMarkerChange: update => update.startState.field(marks) !== update.state.field(marks),
  });
  const extensions = [
    EditorView.cspNonce.of(nonce), marks, shown, beside, lineNumbers(), history(), drawSelection(),
    highlightActiveLine(), bracketMatching(), StreamLanguage.define(stex), syntaxHighlighting(colours),
    keymap.of([...defaultKeymap, ...historyKeymap, ...searchKeymap]), EditorView.lineWrapping,
    EditorView.contentAttributes.of({ "aria-label": "Source", spellcheck: "false" }),
    EditorView.updateListener.of(update => { if (update.docChanged) onChange(); }),
  ];
  const view = new EditorView({ parent, state: EditorState.create({ extensions }) });
  const inside = place => place.map(at => Math.max(0, Math.min(at, view.state.doc.length)));
  return {
    text: () => view.state.doc.toString(),
    // A new text, of which nothing can be undone.
    set(text) { view.setState(EditorState.create({ doc: text, extensions })); onChange(); },
    apply(edits) {
      const changes = edits.map(({ place: [from, to], new: insert }) => ({ from, to, insert }));
      view.dispatch({ changes, userEvent: "input.apply", scrollIntoView: true });
    },
    tell(displays, findings) {
      const placed = displays.filter(each => each.place);
      const own = placed.map(each => ({ at: inside(each.place)[0], grade: each.grade, name: each.name }));
      view.dispatch({ effects: setMarks.of(own) });
      const diagnostics = findings.map(({ place, level, message }) => {
        const [from, to] = inside(place);
        return { from, to: Math.max(from, to), severity: level, message };
      });
      view.dispatch(setDiagnostics(view.state, diagnostics));
    },
    show(place) {
      const [from, to] = inside(place);
      const mark = from < to ? Decoration.set([Decoration.mark({ class: "cm-shown" }).range(from, to)]) : Decoration.none;
      view.dispatch({ effects: [setShown.of(mark), EditorView.scrollIntoView(from, { y: "center" })] });
    },
    focus: () => view.focus(),
  };
}
