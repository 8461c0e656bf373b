import type { Shape } from "../shape.ts";

/** The dialog that takes a contour from a drawing. */
export const drawingImport = {
  title: "Contour from a drawing",
  choose: "Choose a drawing",
  chooseOther: "Other drawing",
  drop: (endings: string) => `Choose a drawing or drop it here: ${endings}.`,
  reading: "Reading the drawing …",
  cancel: "Cancel",
  take: "Use contour",
  replaces: (elements: number) =>
    elements === 1
      ? "Replaces the element in the table; undo restores it."
      : `Replaces the ${elements} elements in the table; undo restores them.`,
  newProgram: "Create program",
  cycle: "Cycle",
  sheet: "Drawing",
  sheetKeys:
    "Arrow keys select the next contour, axis or zero point, as chosen above; plus and minus zoom, 0 shows all, Shift with arrow keys pans.",
  picture: (elements: number) =>
    elements === 0
      ? "Drawing without a selected contour"
      : `Drawing with a contour of ${elements === 1 ? "1 element" : `${elements} elements`}`,
  pick: {
    label: "A tap in the drawing selects",
    contour: "Contour",
    axis: "Axis",
    zero: "Z0",
    how: {
      contour: "Tap a line of the contour: outside or bore, half and piece follow.",
      axis: "Tap a line on the axis of rotation, or drag the axis.",
      zero: "Tap a point or a line at Z0, or drag the zero point.",
    },
  },
  showContour: "Zoom to contour",
  refused: {
    notStraight: "The axis of rotation is a horizontal or vertical line.",
    nothingHere: "Nothing to select here.",
    notOfContour: "With this axis, the line is part of no contour.",
  },
  chosen: "Selected",
  proposed: "proposed",
  useProposal: "Restore proposal",
  body: "Solid",
  bodyOf: (number: number, name: string, across: string, length: string) =>
    `${number}: ${name} ⌀ ${across} × ${length} mm`.replace("  ", " "),
  unit: "Unit of the drawing",
  units: { mm: "Millimetres", inch: "Inches" },
  source: {
    file: "stated in the file",
    measurement: "from the measurement system of the file",
    assumed: "assumed: the file states no unit",
    chosen: "selected",
  },
  size: (width: string, height: string, unit: string) => `Drawing ${width} × ${height} ${unit}`,
  partSize: (across: string, length: string) => `⌀ ${across} × ${length} mm`,
  axis: "Axis of rotation",
  level: "Horizontal",
  upright: "Vertical",
  axisAt: { x: "at y", y: "at x" },
  zero: "Workpiece zero Z0",
  zeroAt: { x: "at x", y: "at y" },
  atEnd: { x: { low: "Left end", high: "Right end" }, y: { low: "Lower end", high: "Upper end" } },
  zWay: "Z+ points",
  zWays: { x: { forward: "to the right", back: "to the left" }, y: { forward: "up", back: "down" } },
  half: "Half",
  halves: { x: { upper: "Upper half", lower: "Lower half" }, y: { upper: "Right half", lower: "Left half" } },
  side: "Contour",
  sides: { outside: "Outside", bore: "Bore" },
  piece: "Piece",
  pieceOf: (number: number, all: number, length: string) => `${number} of ${all}, length ${length} mm`,
  diameters: "Drawn with X as a diameter",
  thin: "Take hidden and thin lines, too",
  layers: "Layers",
  reversed: "Reverse direction",
  gap: "Gap tolerance (mm)",
  more: "More options",
  result: "Contour in the table",
  resultHow: "Arrow keys show each element in the drawing.",
  moreRows: (count: number) => `${count} more elements`,
  noContour: "No contour with these choices.",
  notes: "Notes on the drawing",
  leftOut: (count: number) =>
    count === 1 ? "1 note on lines left out or converted" : `${count} notes on lines left out or converted`,
  closeGap: "Close gap",
  closeGapOf: (note: number) => `Close the gap of note ${note}`,
  moreNotes: (count: number) => (count === 1 ? "1 more note" : `${count} more notes`),
};

export type DrawingImportTexts = Shape<typeof drawingImport>;
