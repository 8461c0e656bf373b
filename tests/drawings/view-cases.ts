import { line, polyline } from "./dxf-file.ts";
import { REFERENCE, FACED, QUARTER, mm, sideView, type Case } from "./shaft.ts";

/** One shaft in the views of drawings. */
export const viewCases: readonly Case[] = [
  [
    "lower half",
    mm([
      polyline(false, [
        [0, -12],
        [-18, -12, QUARTER],
        [-22, -16],
        [-22, -27],
        [-46, -27],
      ]),
    ]),
    REFERENCE,
  ],
  [
    "drawn downwards about a vertical axis",
    mm([
      polyline(false, [
        [12, 0],
        [12, -18, QUARTER],
        [16, -22],
        [27, -22],
        [27, -46],
      ]),
    ]),
    REFERENCE,
  ],
  ["side view with shoulders across the axis", mm(sideView()), FACED, ["otherHalf"]],
  ["an edge seen across the axis", mm([...sideView(), line(-9, -12, -9, 12)]), FACED, ["insideLines", "otherHalf"]],
  [
    "side view on a sheet: axis by its centre line, frame and end view beside it",
    mm([
      ...sideView(160, 150),
      line(170, 150, 104, 150, "8 0 6 CENTER"),
      line(220, 115, 220, 185, "8 0 6 CENTER"),
      "CIRCLE 8 0 10 220 20 150 40 27",
      "CIRCLE 8 0 10 220 20 150 40 12",
      polyline(true, [
        [10, 10],
        [410, 10],
        [410, 287],
        [10, 287],
      ]),
    ]),
    FACED,
    ["otherHalf", "otherPieces"],
  ],
  [
    "centre line by its pattern and a name of the trade, thread and hidden lines",
    mm(
      [
        ...sideView(160, 150),
        line(170, 150, 104, 150, "8 0 6 LINIE4"),
        line(160, 160, 146, 160, "8 GEWINDE"),
        line(160, 140, 146, 140, "8 GEWINDE"),
        line(160, 155, 130, 155, "8 0 6 VERDECKT"),
      ],
      { linetypes: ["LTYPE 2 LINIE4 70 0 3 x 72 65 73 4 40 20"] },
    ),
    FACED,
    ["otherHalf", "notOutline"],
  ],
  [
    "thin lines by their width",
    mm([...sideView(0, 0, "8 0 370 50"), line(0, 10, -14, 10, "8 0 370 25"), line(0, -10, -14, -10, "8 0 370 25")]),
    FACED,
    ["otherHalf", "notOutline"],
  ],
  [
    "X drawn from the origin, thick end to the right: the face is at the origin",
    mm([
      polyline(false, [
        [0, 12],
        [18, 12, QUARTER],
        [22, 16],
        [22, 27],
        [46, 27],
      ]),
    ]),
    REFERENCE,
  ],
];
