import type { Tool } from "../../kernel/plan/tool.ts";
import { toScreen, type Camera, type Place, type Size } from "../camera.ts";
import type { SectionKind } from "../material/paint-target.ts";
import { at } from "../../kernel/geometry/point.ts";
import { toolBox } from "./drawing.ts";
import type { Silhouette } from "./silhouette.ts";

/** The visible part of a tool that the work may cover, and the rest of it, as values of CSS `clip-path`. */
export interface Windows {
  readonly seen: string;
  /** The rest; from outside only its edges are drawn, behind the work. */
  readonly other: string;
}

/** Whether a tool lies towards the axis from its tip, as boring bars and drills do: it may reach over the axis. */
export function liesInward(tool: Tool): boolean {
  const box = toolBox(tool);
  return box !== null && -box.low >= box.high;
}

const boxOf = (width: number, top: number, bottom: number): Place[] => [
  { x: 0, y: top },
  { x: width, y: top },
  { x: width, y: bottom },
  { x: 0, y: bottom },
];

/** The points inside an odd number of areas, each area closed back to its first place and to that of the first area. */
function inOne(areas: readonly (readonly Place[])[], length: (pixels: number) => string): string {
  const [first] = areas[0] ?? [],
    round = areas.flatMap((area) => [...area, ...area.slice(0, 1), ...(first ? [first] : [])]);
  const n = (v: number) => length(Math.round(v * 10) / 10);
  return `polygon(evenodd, ${round.map(({ x, y }) => `${n(x)} ${n(y)}`).join(", ")})`;
}

/**
 * The clip windows of a tool that the work may cover. A half section is open on the tool's side of the axis; on the
 * other side, and in a view from outside on both sides, the work covers everything nearer to the axis than its edge.
 * Null if the whole tool is visible. `length` writes a length for the style.
 */
export function windowsOf(
  section: SectionKind,
  camera: Camera,
  { width, height }: Size,
  silhouette: Silhouette,
  length: (pixels: number) => string = (pixels) => `${pixels}px`,
): Windows | null {
  if (section === "full" || silhouette.length === 0) return null;
  const { zero, xUp } = camera,
    onTools = silhouette.map((p) => toScreen(camera, p));
  const beyond = silhouette.map((p) => toScreen(camera, at(p.z, -p.r)));
  if (section === "outside") {
    const covered = [...onTools, ...beyond.toReversed()];
    return { seen: inOne([boxOf(width, 0, height), covered], length), other: inOne([covered], length) };
  }
  const [above, below] = [boxOf(width, 0, zero.y), boxOf(width, zero.y, height)],
    [open, closed] = xUp ? [above, below] : [below, above];
  const onAxis = [beyond.at(-1), beyond[0]].flatMap((place) => (place ? [{ x: place.x, y: zero.y }] : []));
  return { seen: inOne([open], length), other: inOne([closed, [...beyond, ...onAxis]], length) };
}
