import { acrossRadius, asPage, brush, type Half, type PaintTarget } from "./paint-target.ts";
import { flanksOf, silhouette, type HalfTurn, type ScreenPoint, type ThreadZone } from "./thread-zone.ts";

function way({ pen }: PaintTarget, places: readonly ScreenPoint[]): void {
  places.forEach(([x, y], i) => {
    if (i === 0) pen.moveTo(x, y);
    else pen.lineTo(x, y);
  });
}

/** How strongly flanks are shaded, and their crests drawn. */
const FLANK = 0.34;
const CREST = 0.55;

/** The part of the half turn shown in a half of the picture: the tool's side is the first quarter. */
const turnsOf = (isToolSide: boolean): HalfTurn => (isToolSide ? [0, 0.5] : [0.5, 1]);

/** A thread on the outside of a half, or on the wall of a hollow behind the cut. */
export function paintThread(easel: PaintTarget, half: Half, zone: ThreadZone): void {
  const { pen, camera, colours } = easel,
    { scale, zero, xUp } = camera;
  const isToolSide = half.down === (xUp ? -1 : 1),
    turns = turnsOf(isToolSide),
    edge = silhouette(camera, zone, isToolSide ? 0 : 1);
  const [begin, end] = [zero.x + zone.left * scale, zero.x + zone.right * scale];
  const far = zone.profile.reduce((most, p) => Math.max(most, p.r), 0),
    reach = far * scale + 2;
  pen.save();
  pen.beginPath();
  pen.rect(begin, half.down > 0 ? zero.y - 1 : zero.y - reach, end - begin, reach + 1);
  pen.clip();
  pen.beginPath();
  way(easel, [...edge, [end + zone.lead * scale, zero.y - half.down], [begin - zone.lead * scale, zero.y - half.down]]);
  pen.closePath();
  acrossRadius(easel, half.down, far);
  pen.fillStyle = brush(easel, "steel", 0, "thread", half.isCut ? "hole" : half.facing);
  pen.fill();
  asPage(easel);
  pen.save();
  pen.clip();
  const { flanks, crests } = flanksOf(camera, zone, turns);
  for (const looksRight of [true, false]) {
    pen.beginPath();
    for (const flank of flanks) {
      if (flank.looksRight !== looksRight) continue;
      way(easel, flank.outline);
      pen.closePath();
    }
    pen.globalAlpha = FLANK;
    pen.fillStyle = looksRight ? colours.steelLight : colours.steelDark;
    pen.fill();
  }
  pen.globalAlpha = CREST;
  pen.beginPath();
  for (const crest of crests) way(easel, crest);
  pen.strokeStyle = colours.edge;
  pen.lineWidth = 0.75;
  pen.stroke();
  pen.restore();
  if (!half.isCut) {
    pen.beginPath();
    way(easel, edge);
    pen.lineWidth = 1;
    pen.stroke();
  }
  pen.restore();
}
