const unfold = () => { const at = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  for (let up = at; up; up = up.parentElement) if (up.matches("details")) up.open = true; };
addEventListener("hashchange", unfold); unfold();
const plain = text => text.replace(/[()\s]/g, "").toLowerCase();
document.querySelector(".jump").addEventListener("submit", event => { event.preventDefault();
  const wanted = plain(document.getElementById("jump").value), answer = event.target.querySelector("output");
  const found = [...document.querySelectorAll("article[data-name]")].find(at => plain(at.dataset.name) === wanted);
  answer.value = found ? "" : `no equation (${wanted})`;
  if (found) { location.hash = found.id; found.scrollIntoView(); } });
