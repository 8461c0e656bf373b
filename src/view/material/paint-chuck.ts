import type { ChuckDrawing, ChuckPoint } from "./chuck.ts";
import type { Bounds } from "../camera.ts";
import { breakOutline } from "./break-outline.ts";
import { acrossRadius, asPage, brush, trace, type Half, type SectionKind, type PaintTarget } from "./paint-target.ts";

/** Opacity of the clamping's edges, which are quieter than those of the work. */
const QUIET = 0.6;

function area(easel: PaintTarget, down: 1 | -1, places: readonly ChuckPoint[], fill: string): void {
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

function line(easel: PaintTarget, down: 1 | -1, places: readonly ChuckPoint[]): void {
  easel.pen.beginPath();
  trace(easel, down, places);
  easel.pen.stroke();
}

/** Begins the outline of what is drawn of a clamping, on both sides of the axis. */
function cutOutline({ pen, camera: { zero, scale } }: PaintTarget, { left, right, high, low }: Bounds): void {
  const seen = { left: left * scale, right: right * scale, low: low * scale, high: high * scale };
  pen.beginPath();
  breakOutline(seen).forEach(({ x, y }, i) =>
    i === 0 ? pen.moveTo(zero.x + x, zero.y + y) : pen.lineTo(zero.x + x, zero.y + y),
  );
  pen.closePath();
}

/** Paints bodies of a clamping as far as its break lines, and these lines where they cross the bodies. */
function withBreaks(
  easel: PaintTarget,
  cut: Bounds | null,
  bodies: readonly { readonly down: 1 | -1; readonly places: readonly ChuckPoint[] }[],
  paint: () => void,
): void {
  const { pen, colours } = easel;
  pen.save();
  if (cut) {
    cutOutline(easel, cut);
    pen.clip();
  }
  paint();
  pen.restore();
  if (!cut) return;
  pen.lineWidth = 1;
  pen.strokeStyle = colours.edge;
  for (const { down, places } of bodies) {
    pen.save();
    pen.beginPath();
    trace(easel, down, places);
    pen.closePath();
    pen.clip();
    cutOutline(easel, cut);
    pen.stroke();
    pen.restore();
  }
}

/** A body of revolution from outside. */
function turned(easel: PaintTarget, { down, facing }: Half, places: readonly ChuckPoint[]): void {
  const { pen, colours } = easel;
  pen.beginPath();
  trace(easel, down, places);
  pen.closePath();
  acrossRadius(easel, down, Math.max(...places.map(([, r]) => r)));
  pen.fillStyle = brush(easel, "chuck", 0, "rough", facing);
  pen.fill();
  asPage(easel);
  pen.strokeStyle = colours.edge;
  pen.globalAlpha = QUIET;
  pen.stroke();
  pen.globalAlpha = 1;
}

/** The plane at the rear end of a blank whose clamping is not stated. */
function plane(easel: PaintTarget, down: 1 | -1, { plane, hatch }: NonNullable<ChuckDrawing["unstated"]>): void {
  const { pen, colours } = easel;
  pen.strokeStyle = colours.edge;
  pen.lineWidth = 2;
  line(
    easel,
    down,
    plane.map(({ z, r }) => [z, r]),
  );
  pen.lineWidth = 1;
  for (const each of hatch)
    line(
      easel,
      down,
      each.map(({ z, r }) => [z, r]),
    );
}

/** Paints the clamping, behind the work. */
export function paintChuck(
  easel: PaintTarget,
  halves: readonly [Half, Half],
  section: SectionKind,
  chuck: ChuckDrawing,
): void {
  const { pen, colours } = easel;
  pen.lineWidth = 1;
  const jawHalves = section === "full" ? halves : halves.slice(0, 1);
  const bodies = [
    ...halves.flatMap(({ down }) => chuck.turned.map((places) => ({ down, places }))),
    ...jawHalves.flatMap(({ down }) => chuck.jaws.map((places) => ({ down, places }))),
  ];
  withBreaks(easel, chuck.cut, bodies, () => {
    for (const half of halves) for (const places of chuck.turned) turned(easel, half, places);
    for (const { down } of jawHalves) for (const jaw of chuck.jaws) area(easel, down, jaw, colours.chuckLight);
  });
  for (const { down } of halves) if (chuck.unstated) plane(easel, down, chuck.unstated);
}

/** The stated limit, dashed across the picture. */
function limits(easel: PaintTarget, halves: readonly [Half, Half], { limit, all }: ChuckDrawing): void {
  if (!limit) return;
  const { pen, colours } = easel,
    { z = all.right, r = all.high * 1.5 } = limit;
  pen.strokeStyle = colours.edge;
  pen.setLineDash([8, 4]);
  for (const { down } of halves) {
    if (limit.z !== undefined)
      line(easel, down, [
        [z, 0],
        [z, r],
      ]);
    if (limit.r !== undefined)
      line(easel, down, [
        [all.left, r],
        [z, r],
      ]);
  }
  pen.setLineDash([]);
}

/**
 * The jaw in front of the work: a full section cuts it away, a half section cuts away the part that reaches over the
 * axis.
 */
export function paintFrontJaw(
  easel: PaintTarget,
  halves: readonly [Half, Half],
  section: SectionKind,
  chuck: ChuckDrawing,
): void {
  const {
      pen,
      colours,
      camera: { zero, scale },
    } = easel,
    [{ down }, other] = halves;
  pen.lineWidth = 1;
  limits(easel, halves, chuck);
  if (section === "full" || chuck.flanks.length === 0) return;
  pen.save();
  if (section === "half") {
    const { left, right, high } = chuck.all;
    pen.beginPath();
    pen.rect(zero.x + left * scale, zero.y, (right - left) * scale + 1, other.down * high * scale);
    pen.clip();
  }
  const bodies = [...chuck.flanks, ...chuck.backs].map((places) => ({ down, places }));
  withBreaks(easel, chuck.cut, bodies, () => {
    for (const flank of chuck.flanks) area(easel, down, flank, colours.chuckLight);
    for (const back of chuck.backs) area(easel, down, back, colours.chuck);
  });
  pen.restore();
}
