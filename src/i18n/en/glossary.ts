import type { GlossaryTexts } from "../glossary-text.ts";

export const glossary: GlossaryTexts = {
  words: { formsOf: (name) => `${name}(?:e?s)?`, capitals: false, apart: true },
  blank: {
    name: "Blank",
    text: "The material before the first cut. BLK FORM says it; here it is a cylinder, a tube or an outline.",
  },
  stock: { name: "Stock", text: "The material at a moment: what the cuts so far have left of the blank." },
  finishedPart: { name: "Finished part", text: "What has to remain. No cut may touch it." },
  residue: {
    name: "Residue",
    text: "Material that stays beyond the contour because the insert cannot get there: in corners, behind flanks, under limits.",
  },
  contour: {
    name: "Contour",
    text: "The line of lines and arcs that the finished surface follows, in the direction of machining.",
  },
  cornerElement: {
    name: "Chamfer, rounding",
    text: "What breaks a corner between two elements, or the edge at the start or end of a shoulder.",
  },
  shoulder: { name: "Shoulder", text: "A cylinder and a face that meet in an inside corner." },
  face: { name: "Face", text: "A surface square to the axis. It is turned by moving in X." },
  recess: {
    name: "Recess, groove",
    text: "A floor between two walls. Recess turning cuts it sideways, recessing by plunges side by side.",
  },
  undercut: {
    name: "Undercut",
    text: "A relief below the finished diameter in the corner before a face, so that a mating part or a grinding wheel has room.",
  },
  thread: {
    name: "Thread",
    text: "A groove along a helix. Its feed is locked to the turning of the spindle, so that every pass meets the same groove.",
  },
  pitch: {
    name: "Pitch",
    text: "From one groove to the next. With several starts the lead, the way in one turn, is that many times the pitch.",
  },
  runIn: { name: "Run-in", text: "Way in front of a thread on which the axis gets up to its speed." },
  oversize: { name: "Oversize", text: "What roughing leaves for finishing: Q483 on the diameter, Q484 along Z." },
  workpieceZero: {
    name: "Workpiece zero",
    text: "Where X0 and Z0 lie. X0 is the axis of the spindle; Z0 usually lies on the finished face, and the part on the negative side.",
  },
  diameter: { name: "Diameter (⌀)", text: "X is written as a diameter. A step of 2 mm in X moves the tool by 1 mm." },
  radius: {
    name: "On the radius (r)",
    text: "Depths across the axis count on one side only: 3 mm make 6 mm on the diameter.",
  },
  theoreticalTip: {
    name: "Theoretical tip",
    text:
      "The corner that the insert would have without its nose radius. The control shows and programs the " +
      "position of this point, although there is no steel.",
  },
  cuttingPoint: {
    name: "Cutting point",
    text: "Where the nose touches the work. On a cylinder and a face it is level with the theoretical tip, on tapers and arcs it is not.",
  },
  tipOrientation: {
    name: "Tip orientation (TO)",
    text: "Where the theoretical tip lies beside the nose, 1 to 9. It tells the control on which side the insert cuts.",
  },
  noseRadius: {
    name: "Nose radius (RS)",
    text: "The rounding of the cutting corner. It leaves its own radius in sharp inside corners and makes the feed marks of the surface.",
  },
  compensation: {
    name: "Nose radius compensation",
    text: "The control leads the nose so that its arc touches the contour, not the theoretical tip. Without it cones and arcs come out wrong.",
  },
  insert: { name: "Insert", text: "The exchangeable plate that cuts, with its shape, angles and nose radius." },
  mainEdge: {
    name: "Main edge",
    text: "The edge beside the nose that does most of the cutting. A wall that leans more than it cannot be followed.",
  },
  secondaryEdge: {
    name: "Secondary edge",
    text: "The edge behind the nose. On falling flanks it has to stay clear of the part.",
  },
  edgeLength: {
    name: "Edge length (CUTLENGTH)",
    text: "How much of the edge may cut. A pass deeper than that works with the holder. Of a thread tool: how high its tooth is.",
  },
  holder: { name: "Holder", text: "What carries the insert. It must touch neither the part nor the chuck." },
  pass: { name: "Pass", text: "One roughing cut at one depth, from the infeed to the retraction." },
  infeed: {
    name: "Infeed",
    text: "How much deeper a pass lies than the one before. Q463 is the most that is allowed; the depth is divided evenly.",
  },
  roughing: { name: "Roughing", text: "Taking most of the material in few deep passes, down to the oversize." },
  finishing: { name: "Finishing", text: "One cut along the contour to its size, with little chip and a small feed." },
  setupClearance: {
    name: "Set-up clearance (Q460)",
    text: "The distance that a cycle keeps from the work when it pre-positions, and by which it moves off before it goes back at rapid.",
  },
  startPoint: {
    name: "Start point",
    text: "Where the tip stands when a cycle is called. It lies in the air; from there the cycle counts its depth, and there it returns.",
  },
  rapid: { name: "Rapid", text: "The fastest move of the axes. It must never touch material." },
  feedPerTurn: {
    name: "Feed per revolution (M136)",
    text: "How far the tool goes in one turn of the spindle. It makes chip thickness and surface independent of the speed.",
  },
  cuttingSpeed: {
    name: "Cutting speed",
    text: "How fast the surface passes the edge, m/min: π · ⌀ · n / 1000. VCONST holds it while the diameter changes.",
  },
  speedLimit: {
    name: "Speed limit (SMAX)",
    text:
      "The highest speed that the control may choose. Near the axis VCONST would want an endless one: the " +
      "chuck and the part set the bound.",
  },
  chip: {
    name: "Chip",
    text: "What is cut off: depth times feed is its cross-section, and force and power grow with it.",
  },
  cuttingForce: {
    name: "Specific cutting force (kc)",
    text: "The force for each mm² of chip. Thin chips need more of it than thick ones.",
  },
  roughness: {
    name: "Roughness (Rz)",
    text: "Height of the feed marks. The nose alone leaves about f² / (8 · r): half the feed is a quarter of the height.",
  },
  gouge: { name: "Gouge", text: "Finished part that a move has cut away. It cannot be put back." },
  airPass: { name: "Air pass", text: "A pass that touches no material." },
  plunging: {
    name: "Plunging",
    text: "Cutting into the material along a falling flank or straight down. Q487 allows it and Q488 gives it a feed of its own.",
  },
  limit: {
    name: "Machining limit",
    text: "A diameter (Q480) or a place along Z (Q482) beyond which the cycle does not cut.",
  },
  program: { name: "Program", text: "What the control works through: blocks, one after the other." },
  block: {
    name: "Block",
    text: "One numbered line of a program, or several that belong together, such as a cycle with its parameters.",
  },
  cycle: { name: "Cycle", text: "A machining job that the control knows: from a few values it plans all its passes." },
  call: {
    name: "Cycle call",
    text: "M99, M89 or CYCL CALL. Only here the defined cycle moves the tool, with the tool and start point of that moment.",
  },
  verdict: {
    name: "Verdict",
    text: "What the proof of a program says: proved, faults found, or not everything simulated.",
  },
};
