import { arc, asBinary, asText, bytesOf, dxfGroups, line, MM, polyline, utf8 } from "./dxf-file.ts";
import {
  REFERENCE,
  profile,
  QUARTER,
  inches,
  text,
  mm,
  LAYERS,
  bezier,
  rational,
  straight,
  lines3,
  old,
  BACK,
  type Case,
} from "./shaft.ts";

/** One shaft drawn with the entities of many programs. */
export const entityCases: readonly Case[] = [
  ["lines and an arc", mm(profile()), REFERENCE],
  [
    "seen from behind: lines in the world, arcs in their own coordinates",
    mm([
      line(0, 12, -18, 12, BACK),
      arc(18, 16, 4, 270, 360, BACK),
      line(-22, 16, -22, 27, BACK),
      line(-22, 27, -46, 27, BACK),
    ]),
    REFERENCE,
  ],
  [
    "polyline seen from behind",
    mm([
      polyline(
        false,
        [
          [0, 12],
          [18, 12, QUARTER],
          [22, 16],
          [22, 27],
          [46, 27],
        ],
        BACK,
      ),
    ]),
    REFERENCE,
  ],
  [
    "polyline of release 12",
    mm(
      old(
        [
          [0, 12],
          [-18, 12, -QUARTER],
          [-22, 16],
          [-22, 27],
          [-46, 27],
        ],
        0,
      ),
    ),
    REFERENCE,
  ],
  [
    "polyline with control points of its spline",
    mm(
      old(
        [
          [0, 12],
          [-18, 12, -QUARTER],
          [-22, 16],
          [-22, 27],
          [-46, 27],
        ],
        4,
      ).toSpliced(2, 0, "VERTEX 8 0 10 50 20 50 70 16"),
    ),
    REFERENCE,
  ],
  [
    "polylines in space",
    mm([
      ...old(
        [
          [0, 12],
          [-18, 12],
        ],
        8,
      ),
      arc(-18, 16, 4, 180, 270),
      ...old(
        [
          [-22, 16],
          [-22, 27],
          [-46, 27],
        ],
        8,
      ),
    ]),
    REFERENCE,
  ],
  [
    "layer off and layer frozen",
    mm([...profile(), line(-46, 27, -90, 27, "8 OFF"), line(0, 12, 9, 12, "8 ICE")], { layers: LAYERS }),
    REFERENCE,
    ["hiddenLayer", "hiddenLayer"],
  ],
  [
    "invisible, and in paper space",
    mm([...profile(), line(-46, 27, -90, 27, "8 0 60 1"), line(-46, 27, -90, 27, "8 0 67 1")]),
    REFERENCE,
    ["paperSpace", "invisible"],
  ],
  ["in paper space only", mm(profile("8 0 67 1")), REFERENCE, ["paperUsed"]],
  [
    "inches by INSUNITS",
    text({ header: [["$INSUNITS", 70, 1]], entities: profile().map(inches) }),
    REFERENCE,
    ["unitConverted"],
  ],
  [
    "inches by MEASUREMENT",
    text({
      header: [
        ["$INSUNITS", 70, 0],
        ["$MEASUREMENT", 70, 0],
      ],
      entities: profile().map(inches),
    }),
    REFERENCE,
    ["unitConverted"],
  ],
  [
    "centimetres",
    text({
      header: [["$INSUNITS", 70, 5]],
      entities: [
        polyline(false, [
          [0, 1.2],
          [-1.8, 1.2, -QUARTER],
          [-2.2, 1.6],
          [-2.2, 2.7],
          [-4.6, 2.7],
        ]),
      ],
    }),
    REFERENCE,
    ["unitConverted"],
  ],
  ["no unit, no header", text({ entities: profile() }), REFERENCE, ["unitAssumed"]],
  [
    "drawn twice, the second time backwards",
    mm([...profile(), line(-18, 12, 0, 12), arc(-18, 16, 4, 180, 270), line(-22, 27, -22, 16), line(-46, 27, -22, 27)]),
    REFERENCE,
    ["doubled"],
  ],
  [
    "drawn over in part, across its end",
    mm([...profile(), line(-4, 12, -10, 12), line(-40, 27, -46, 27), arc(-18, 16, 4, 200, 250)]),
    REFERENCE,
    ["doubled"],
  ],
  [
    "two overlapping lines and arcs make one",
    mm([
      line(0, 12, -12, 12),
      line(-18, 12, -6, 12),
      arc(-18, 16, 4, 180, 240),
      arc(-18, 16, 4, 210, 270),
      ...profile().slice(2),
    ]),
    REFERENCE,
    ["doubled"],
  ],
  [
    "ellipse with equal axes",
    mm([...lines3, "ELLIPSE 8 0 10 -18 20 16 11 -4 21 0 40 1 41 0 42 1.5707963267948966"]),
    REFERENCE,
  ],
  ["Bézier curve", mm([...lines3, bezier]), REFERENCE, ["fitted"]],
  ["rational spline", mm([...lines3, rational]), REFERENCE, ["fitted"]],
  [
    "everything as splines, straight ones of degree 1",
    mm([straight(0, 12, -18, 12), rational, straight(-22, 16, -22, 27), straight(-22, 27, -46, 27)]),
    REFERENCE,
    ["fitted", "fitted"].slice(1),
  ],
  ["block", mm(["INSERT 8 0 2 P 10 0 20 0"], { blocks: { P: profile() } }), REFERENCE],
  [
    "block in a block, mirrored, turned and scaled back",
    mm(["INSERT 8 0 2 Q 10 0 20 0 41 -1 50 180"], {
      blocks: { P: profile(), Q: ["INSERT 8 0 2 P 10 0 20 0 41 1 42 -1"] },
    }),
    REFERENCE,
  ],
  [
    "block seen from behind",
    mm(["INSERT 8 0 2 P 10 0 20 0 41 -1 210 0 220 0 230 -1"], { blocks: { P: profile() } }),
    REFERENCE,
  ],
  [
    "block of ellipses stretched to circles",
    mm(["INSERT 8 0 2 P 10 0 20 0 41 2"], {
      blocks: {
        P: [
          line(0, 12, -9, 12),
          "ELLIPSE 8 0 10 -9 20 16 11 0 21 4 40 0.5 41 1.5707963267948966 42 3.141592653589793",
          line(-11, 16, -11, 27),
          line(-11, 27, -23, 27),
        ],
      },
    }),
    REFERENCE,
  ],
  [
    "array of blocks, far apart",
    mm(["INSERT 8 0 2 P 10 0 20 0 70 2 44 -200"], { blocks: { P: profile() } }),
    REFERENCE,
    ["otherPieces"],
  ],
  [
    "block on a layer that is off: what is on layer 0 is hidden with it",
    mm([...profile(), "INSERT 8 OFF 2 H 10 0 20 0"], { layers: LAYERS, blocks: { H: [line(-46, 27, -90, 27)] } }),
    REFERENCE,
    ["hiddenLayer"],
  ],
  [
    "block that is missing, block that contains itself",
    mm([...profile(), "INSERT 8 0 2 NONE 10 0 20 0", "INSERT 8 0 2 R 10 0 20 0"], {
      blocks: { R: ["INSERT 8 0 2 R 10 1 20 0"] },
    }),
    REFERENCE,
    ["missingBlock", "recursiveBlock"],
  ],
  [
    "in the xz plane, arcs with their extrusion",
    mm([
      "LINE 8 0 10 0 20 5 30 12 11 -18 21 5 31 12",
      "ARC 8 0 10 18 20 16 30 5 40 4 50 270 51 0 210 0 220 1 230 0",
      "LINE 8 0 10 -22 20 5 30 16 11 -22 21 5 31 27",
      "LINE 8 0 10 -22 20 5 30 27 11 -46 21 5 31 27",
    ]),
    REFERENCE,
    ["plane"],
  ],
  [
    "in the yz plane",
    mm([
      "LINE 8 0 10 0 20 0 30 12 11 0 21 -18 31 12",
      "ARC 8 0 10 -18 20 16 30 0 40 4 50 180 51 270 210 1 220 0 230 0",
      "LINE 8 0 10 0 20 -22 30 16 11 0 21 -22 31 27",
      "LINE 8 0 10 0 20 -22 30 27 11 0 21 -46 31 27",
    ]),
    REFERENCE,
    ["plane"],
  ],
  [
    "on different heights above the plane",
    mm(["LINE 8 0 10 0 20 12 30 3 11 -18 21 12 31 3", ...profile().slice(1)]),
    REFERENCE,
  ],
  ["binary", asBinary(dxfGroups({ header: MM, entities: profile() })), REFERENCE],
  ["binary of release 12", asBinary(dxfGroups({ header: MM, entities: profile() }), true), REFERENCE],
  [
    "line ends of Windows and a comment before",
    utf8(`999\r\nfrom a CAD\r\n${asText(dxfGroups({ header: MM, entities: profile() }), "\r\n")}`),
    REFERENCE,
  ],
  [
    "breaks off before its end",
    utf8(asText(dxfGroups({ header: MM, entities: profile() }).slice(0, -2))),
    REFERENCE,
    ["truncated"],
  ],
  [
    "layer names in Windows Latin",
    bytesOf(
      asText(
        dxfGroups({
          header: [...MM, ["$DWGCODEPAGE", 3, "ANSI_1252"]],
          entities: [...profile(), line(-46, 27, -46, 60, "8 MA\u00dfE_BEMA\u00dfUNG")],
        }),
      ),
    ),
    REFERENCE,
    ["notOutline"],
  ],
  [
    "dimensions, text, hatching and leaders are hints",
    mm([
      ...profile(),
      "TEXT 8 0 10 5 20 5 40 3 1 %%c24",
      "MTEXT 8 0 10 5 20 9 1 \\A1;R4",
      "DIMENSION 8 0 2 *D1 10 0 20 0 11 -9 21 20 1 <>H7 42 24",
      "HATCH 8 0 10 0 20 0 2 ANSI31",
      "LEADER 8 0 10 0 20 0",
      "POINT 8 0 10 99 20 99",
    ]),
    REFERENCE,
  ],
  [
    "other entities are named",
    mm([...profile(), "3DSOLID 8 0", "SOLID 8 0 10 0 20 0", "SOLID 8 0 10 0 20 0"]),
    REFERENCE,
    ["skipped", "skipped"],
  ],
  [
    "entities without their numbers are counted",
    mm([...profile(), "LINE 8 0 10 0", "ARC 8 0 10 0 20 0 40 0 50 0 51 9", "LWPOLYLINE 8 0 90 1 10 0 20 0"]),
    REFERENCE,
    ["broken"],
  ],
];
