import type { DrawingTexts } from "../drawing-note.ts";

const many = (count: string, one: string, more: string) => (count === "1" ? `1 ${one}` : `${count} ${more}`);

/** What of a solid is not turned. */
function milled(shape: string, count: string): string {
  if (shape === "flats") return many(count, "flat face", "flat faces");
  if (shape === "holes") return many(count, "off-axis hole", "off-axis holes");
  return shape === "crossHoles" ? many(count, "cross hole", "cross holes") : many(count, "other face", "other faces");
}

export const drawing: DrawingTexts = {
  unknownKind: ({ kinds }) => `This is not a drawing that can be read. Kinds that can: ${kinds}.`,
  unreadable: ({ kind }) => `This file is not a readable ${kind} drawing.`,
  tooLarge: ({ limit }) => `This file is larger than ${limit} MB.`,
  tooMany: ({ limit }) =>
    `The drawing has more than ${limit} lines and arcs. Save the outline of the part alone and import that file.`,
  nothing: () => "The drawing contains no lines, arcs or curves.",
  truncated: () => "The file breaks off before its end; everything up to there was read.",
  hiddenLayer: ({ layer, count }) => `Layer ${layer} is off or frozen: ${many(count, "entity", "entities")} left out.`,
  invisible: ({ count }) => `Left out, invisible: ${many(count, "entity", "entities")}.`,
  paperSpace: ({ count }) => `Left out, on the layout (paper space): ${many(count, "entity", "entities")}.`,
  paperUsed: () => "Model space is empty: the layout was read. Check its scale.",
  skipped: ({ kind, count }) => `Not used: ${count} × ${kind}.`,
  broken: ({ count }) => `Left out, incomplete numbers: ${many(count, "entity", "entities")}.`,
  missingBlock: ({ block }) => `Block ${block} is not in the file; external references have to be bound first.`,
  recursiveBlock: ({ block }) => `Block ${block} contains itself; left out.`,
  otherPlane: ({ count }) => `Left out, not in the plane of the drawing: ${many(count, "entity", "entities")}.`,
  plane: ({ plane }) =>
    plane === "oblique" ? "Drawn in an oblique plane, seen from the front." : `Drawn in the ${plane} plane.`,
  doubled: ({ count }) => `Drawn over each other and merged: ${many(count, "line or arc", "lines and arcs")}.`,
  fitted: ({ kind, count, tolerance }) => `Replaced by arcs and lines within ${tolerance} mm: ${count} × ${kind}.`,
  unitAssumed: ({ width, height }) => `No unit in the file: mm assumed, size ${width} × ${height} mm.`,
  unitConverted: ({ unit }) => `Drawn in ${unit}, converted to mm.`,
  unitsDisagree: ({ unit }) => `The file names two units; ${unit} is used. Check the size.`,
  noContour: () => "No contour on this side of the axis.",
  onlyAxis: () => "All lines are on the axis of rotation.",
  axisUnmarked: ({ x }) =>
    `The drawing does not show the axis of rotation; its place is a proposal. Smallest ⌀ with it: ${x} mm.`,
  gapJoined: ({ width, x, z }) => `Gap of ${width} mm closed at X ⌀ ${x}, Z ${z}.`,
  gapOpen: ({ width, x, z }) => `Gap of ${width} mm open at X ⌀ ${x}, Z ${z}: increase the gap tolerance to close it.`,
  axisLines: ({ count }) => `Left out, on the axis of rotation: ${many(count, "line", "lines")}.`,
  otherHalf: ({ count }) => `On the other side of the axis: ${many(count, "line or arc", "lines and arcs")}.`,
  otherPieces: ({ count }) => `Not connected with the contour: ${many(count, "other piece", "other pieces")}.`,
  insideLines: ({ count }) =>
    `Within the outline, not part of the contour: ${many(count, "line or arc", "lines and arcs")}.`,
  notOutline: ({ count }) =>
    `Hidden or thin, not part of the contour: ${many(count, "line or arc", "lines and arcs")}.`,
  rearFace: ({ z }) => `The rear face at Z ${z} is left out.`,
  noSolid: () => "The file contains no solid.",
  noRevolved: () => "No solid in the file has turned surfaces.",
  otherBodies: ({ name, count, turned }) =>
    `${name === "" ? "One solid" : `Solid ${name}`} is used; ${many(count, "other solid", "other solids")} left out, ${turned === "0" ? "none of them turned" : `${turned} of them turned: select under Solid`}.`,
  notTurned: ({ shape, count }) => `Left out, not turned: ${milled(shape, count)}.`,
};
