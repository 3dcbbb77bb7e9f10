// Curves beside the picture; the line at t and the values in the legend follow the slider.
const colours = run.colours, charts = [], chosen = document.querySelector("#curves select");
for (const name of new Set(["all curves", ...run.curves.map((group) => group.title)])) chosen.add(new Option(name));

// Four digits in the width of an axis: 1.2e8 for stresses in Pa
function digits(value) {
  if (value === null || value === undefined) return "";
  const short = Number(value.toPrecision(4)), size = Math.abs(short);
  return size >= 1e5 || (size > 0 && size < 1e-4) ? short.toExponential().replace("e+", "e") : short.toString();
}

function chart(group) {
  const holder = document.createElement("div"), heading = document.createElement("h2");
  heading.textContent = `${group.title} [${group.unit}]`;
  document.getElementById("charts").append(heading, holder);
  const plot = new uPlot({
    width: 372, height: 150, cursor: { y: false, drag: { x: false, y: false } },
    legend: { live: true },
    scales: { x: { time: false } },
    axes: [
      { size: 26, grid: { stroke: "#eceef2" }, ticks: { size: 4 } },
      { size: 62, grid: { stroke: "#eceef2" }, ticks: { size: 4 }, values: (_, ticks) => ticks.map(digits) },
    ],
    series: [
      { label: "t [s]", value: (_, value) => digits(value) },
      ...group.names.map((name, k) => {
        const own = group.names.length - group.pale.length, which = k < own ? k : group.pale[k - own];
        const dash = k < own ? (k < colours.length ? [] : [6, 3]) : [2, 3];
        return { label: name, stroke: colours[which % colours.length], width: 1.5, pxAlign: 0, dash, value: (_, value) => digits(value) };
      }),
    ],
    hooks: {
      draw: [(self) => {
        const x = self.valToPos(state.t, "x", true), { top, height } = self.bbox;
        self.ctx.save();
        self.ctx.setLineDash([]);
        for (const [t, kind] of run.marks) { // impacts, changes of mode, events: short lines on the time axis
          const at = self.valToPos(t, "x", true);
          self.ctx.strokeStyle = ["#d55e00", "#0072b2", "#6b7280"][kind];
          self.ctx.lineWidth = 1;
          self.ctx.beginPath();
          self.ctx.moveTo(at, top + height - 7);
          self.ctx.lineTo(at, top + height);
          self.ctx.stroke();
        }
        self.ctx.strokeStyle = "#dc2626";
        self.ctx.lineWidth = 1.5;
        self.ctx.setLineDash([]);
        self.ctx.beginPath();
        self.ctx.moveTo(x, top);
        self.ctx.lineTo(x, top + height);
        self.ctx.stroke();
        self.ctx.restore();
      }],
    },
  }, [curveTimes, ...group.values], holder);
  plot.over.addEventListener("mouseleave", () => setTimeout(moveCurves));
  plot.over.addEventListener("click", (event) => show(plot.posToVal(event.offsetX, "x")));
  charts.push({ plot, heading, holder, title: group.title });
}

if (run.curves.length) run.curves.forEach(chart);
else document.getElementById("curves").hidden = true;
chosen.addEventListener("change", () => {
  for (const one of charts) one.heading.hidden = one.holder.hidden = chosen.selectedIndex > 0 && one.title !== chosen.value;
});

function nearest(t) {
  let low = 0, high = curveTimes.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (curveTimes[middle] <= t) low = middle; else high = middle;
  }
  return t - curveTimes[low] < curveTimes[high] - t ? low : high;
}

function moveCurves() {
  const idx = nearest(state.t);
  for (const { plot, holder } of charts) {
    if (holder.hidden) continue;
    plot.redraw(false, false);
    plot.setLegend({ idx });
  }
}
