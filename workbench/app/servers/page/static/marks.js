// The marks of the grades, and small helpers that make elements.
export const SIGNS = { error: "✗", warning: "!", "not judged": "?", ok: "✓", note: "·" };
export const ORDER = ["error", "warning", "not judged", "ok", "note"];
export const GRADE_OF = { error: "error", warning: "warning", "not judged": "not judged", holds: "ok", definition: "note", "left out": "note" };
const MANY = { error: "errors", warning: "warnings", holds: "hold", definition: "definitions", "condition missing": "conditions missing" };

export const slug = grade => grade.replace(" ", "-");
export const counted = (word, count) => `${count} ${count === 1 ? word : MANY[word] ?? word}`;

// An element with its attributes and children; a child that is text is set as text.
export function make(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith("on")) element.addEventListener(key.slice(2), value);
    else if (key === "html") element.innerHTML = value; // escaped, or MathML, by the server
    else if (value === true) element.setAttribute(key, "");
    else if (value !== false && value != null) element.setAttribute(key, value);
  }
  element.append(...children.filter(each => each != null));
  return element;
}

export const sign = grade => make("span", { class: `k ${slug(grade)}`, "aria-hidden": "true" }, SIGNS[grade]);
export const button = (label, onclick, kind = "") => make("button", { type: "button", class: kind || null, onclick }, label);
