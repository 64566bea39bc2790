// What a person does with a report's page, put behind its own script: what came of it is written
// into the page as JSON.
const told = {};
const at = (x, y) => ({clientX: x, clientY: y, bubbles: true});
const box = plan.getBoundingClientRect();

told.way = robot.getAttribute("transform");
slider.value = slider.max;
slider.dispatchEvent(new Event("input"));
told.moved = robot.getAttribute("transform") !== told.way;
told.end = $("now").textContent;
const line = chart.getBoundingClientRect();
chart.dispatchEvent(new MouseEvent("click", at(line.left + 0.5 * line.width, line.top + 5)));
told.charted = +slider.value / +slider.max;

for (const x of [100, 300]) {
  for (const kind of ["pointerdown", "pointerup"]) {
    plan.dispatchEvent(new PointerEvent(kind, at(box.left + x, box.top + 50)));
  }
}
told.measured = parseFloat($("measured").textContent);
told.expected = 200 * view.metres / box.width;

const boxes = [...$("layers").querySelectorAll("input")];
told.layers = boxes.length;
boxes[0].click();
told.hidden = layers.drawn.getAttribute("visibility") === "hidden";

const before = view.metres;
plan.dispatchEvent(new WheelEvent("wheel", {...at(box.left + 10, box.top + 10), deltaY: -500, cancelable: true}));
told.zoomed = view.metres < before;

$("rows").firstChild.click();
told.marked = document.querySelectorAll(".refined.marked").length;

const spoken = document.documentElement.lang;
told.titles = {[spoken]: document.title};
$("language").click();
told.titles[document.documentElement.lang] = document.title;

told.links = [...$("files").querySelectorAll("a")].map((a) => ({name: a.download, is_here: a.href.startsWith("blob:")}));
const output = document.createElement("pre");
output.id = "told";
output.textContent = JSON.stringify(told);
document.body.append(output);
