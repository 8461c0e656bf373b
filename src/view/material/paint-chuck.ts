import { SERRATION, serration, type ChuckDrawing, type ChuckPoint } from "./chuck.ts";
import { acrossRadius, asPage, brush, trace, type Half, type SectionKind, type Easel } from "./easel.ts";

/** Teeth of the serration that are smaller than this are one line, pixels. */
const TEETH = 5;

/** The chuck holds the work and is not looked at: its edges are quieter. */
const QUIET = 0.6;

function area(easel: Easel, down: 1 | -1, places: readonly ChuckPoint[], fill: string): void {
  const { pen, colours } = easel;
  pen.beginPath();
  trace(easel, down, places);
  pen.closePath();
  pen.fillStyle = fill;
  pen.fill();
  pen.strokeStyle = colours.edge;
  pen.globalAlpha = QUIET;
  pen.stroke();
  pen.globalAlpha = 1;
}

function line(easel: Easel, down: 1 | -1, places: readonly ChuckPoint[]): void {
  easel.pen.beginPath();
  trace(easel, down, places);
  easel.pen.stroke();
}

function body(easel: Easel, { down, facing }: Half, chuck: ChuckDrawing): void {
  const { pen, camera, colours } = easel, { face, back, radius, chamfer } = chuck.body;
  pen.beginPath();
  trace(easel, down, [[back, -0.5 / camera.scale], [face, -0.5 / camera.scale], [face, radius - chamfer], [face - chamfer, radius], [
    back,
    radius,
  ]]);
  pen.closePath();
  acrossRadius(easel, down, radius);
  pen.fillStyle = brush(easel, "chuck", 0, "rough", facing);
  pen.fill();
  asPage(easel);
  pen.strokeStyle = colours.edge;
  pen.globalAlpha = QUIET;
  line(easel, down, [[face, 0], [face, radius - chamfer], [face - chamfer, radius], [back, radius]]);
  line(easel, down, [[face - chamfer, 0], [face - chamfer, radius]]);
  pen.globalAlpha = QUIET / 2;
  for (const z of chuck.grooves) line(easel, down, [[z, 0], [z, radius]]);
  pen.setLineDash([12, 3, 2, 3]);
  line(easel, down, [[back, chuck.bolts], [face, chuck.bolts]]);
  pen.setLineDash([]);
  pen.globalAlpha = 1;
}

function jaw(easel: Easel, down: 1 | -1, chuck: ChuckDrawing): void {
  const { pen, colours, camera } = easel;
  area(easel, down, chuck.base, colours.chuck);
  area(easel, down, chuck.jaw, colours.chuckLight);
  if (SERRATION * camera.scale > TEETH) {
    pen.beginPath();
    trace(easel, down, serration(chuck.joint));
    pen.fillStyle = colours.chuck;
    pen.fill();
    pen.globalAlpha = QUIET;
    pen.stroke();
  }
  pen.globalAlpha = 0.6;
  pen.setLineDash([8, 3, 2, 3]);
  line(easel, down, chuck.screw);
  pen.setLineDash([]);
  pen.globalAlpha = 1;
}

/** The chuck behind the work. */
export function paintChuck(easel: Easel, halves: readonly [Half, Half], section: SectionKind, chuck: ChuckDrawing): void {
  easel.pen.lineWidth = 1;
  for (const half of halves) body(easel, half, chuck);
  for (const { down } of section === "full" ? halves : halves.slice(0, 1)) jaw(easel, down, chuck);
}

/** The jaw before the work: a full section has cut it away, a half section what of it reaches over the axis. */
export function paintFrontJaw(easel: Easel, [{ down }, other]: readonly [Half, Half], section: SectionKind, chuck: ChuckDrawing): void {
  if (section === "full") return;
  const { pen, colours, camera: { zero, scale } } = easel, { face, radius } = chuck.body;
  pen.save();
  if (section === "half") {
    pen.beginPath();
    pen.rect(zero.x + face * scale, zero.y, (chuck.seen.right - face) * scale + 1, other.down * radius * scale);
    pen.clip();
  }
  pen.lineWidth = 1;
  area(easel, down, chuck.flank, colours.chuckLight);
  for (const back of chuck.backs) area(easel, down, back, colours.chuck);
  pen.restore();
}
