const unfold = () => { let at = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (!at) return; at.querySelector("details.fold")?.setAttribute("open", "");
  for (let up = at; up; up = up.parentElement) if (up.matches("details")) up.open = true; at.scrollIntoView(); };
addEventListener("hashchange", unfold); unfold();
document.querySelector(".jump").addEventListener("submit", event => { event.preventDefault();
  const wanted = document.getElementById("jump").value.trim().replace(/^\(?(.*?)\)?$/, "$1").toLowerCase();
  const found = [...document.querySelectorAll("#equation-names option")].find(o => o.value.toLowerCase() === wanted);
  if (found) { location.hash = found.dataset.anchor; unfold(); } });
addEventListener("beforeprint", () => document.querySelectorAll(".erratum-group details").forEach(d => d.open = true));
