import type { GlossaryTexts } from "../glossary-text.ts";

export const glossary: GlossaryTexts = {
  words: { formsOf: (name) => `${name}(?:e?s)?`, capitals: false, apart: true },
  blank: {
    name: "Blank",
    text: "The material before the first cut, defined by BLK FORM: a cylinder, a tube or an outline.",
  },
  stock: { name: "Stock", text: "The current material: the blank minus all previous cuts." },
  finishedPart: { name: "Finished part", text: "The part after all cuts, as drawn. No cut may damage it." },
  residue: {
    name: "Residual material",
    text:
      "Material that remains on the contour because the insert cannot reach it: in corners, behind flanks, beyond " +
      "limits.",
  },
  contour: {
    name: "Contour",
    text: "The sequence of lines and arcs of the finished surface, in machining direction.",
  },
  cornerElement: {
    name: "Chamfer, rounding",
    text: "Element that breaks the corner between two elements, or the edge at the start or end of a shoulder.",
    // Not the nose ("its rounding") nor the verb.
    where: String.raw`(?<!\bits )(?!chamfers the\b)`,
  },
  shoulder: { name: "Shoulder", text: "A cylinder and a face that meet in an inside corner." },
  face: { name: "Face", text: "A surface perpendicular to the axis, turned by a movement in X." },
  recess: {
    name: "Recess, groove",
    text: "A floor between two walls. Recess turning cuts it laterally, recessing with plunges side by side.",
    // Not the marks that the feed leaves.
    where: String.raw`(?<!\b(?:leaves|leaves a|fine) )(?!grooves grow\b)`,
  },
  undercut: {
    name: "Undercut",
    text:
      "A recess below the finished diameter in the corner before a face, as clearance for a mating part or a " +
      "grinding wheel.",
  },
  thread: {
    name: "Thread",
    text: "A groove along a helix. The feed is synchronized to the spindle, so every pass follows the same groove.",
  },
  pitch: {
    name: "Pitch",
    text:
      "Distance from one groove to the next. With several starts, the lead (travel per revolution) is the pitch " +
      "times the number of starts.",
  },
  runIn: { name: "Run-in", text: "Distance in front of a thread in which the axis accelerates to the feed." },
  oversize: { name: "Oversize", text: "Material left by roughing for finishing: Q483 on the diameter, Q484 along Z." },
  workpieceZero: {
    name: "Workpiece zero",
    text:
      "Position of X0 and Z0. X0 is the spindle axis; Z0 is usually on the finished face, with the part on the " +
      "negative side.",
  },
  diameter: { name: "Diameter (⌀)", text: "X is programmed as a diameter. 2 mm in X move the tool by 1 mm." },
  radius: {
    name: "On the radius (r)",
    text: "Depths across the axis are per side: 3 mm are 6 mm on the diameter.",
  },
  theoreticalTip: {
    name: "Theoretical tip",
    text:
      "The corner of the insert without its nose radius. The control displays and programs the position of this " +
      "point, although there is no material.",
  },
  cuttingPoint: {
    name: "Cutting point",
    text:
      "Point where the nose touches the part. On cylinders and faces it is level with the theoretical tip, on " +
      "tapers and arcs it is not.",
  },
  tipOrientation: {
    name: "Tip orientation (TO)",
    text: "Position of the theoretical tip relative to the nose, 1 to 9. It defines on which side the insert cuts.",
  },
  noseRadius: {
    name: "Tool nose radius (RS)",
    also: "nose radius",
    text:
      "The rounding of the cutting corner. It remains in sharp inside corners and determines the feed marks on the " +
      "surface.",
  },
  compensation: {
    name: "Tool nose radius compensation",
    also: "nose radius compensation",
    text:
      "The control guides the nose, not the theoretical tip, along the contour. Without compensation tapers and " +
      "arcs are wrong.",
  },
  insert: { name: "Insert", text: "The exchangeable cutting plate with its shape, angles and nose radius." },
  mainEdge: {
    name: "Main cutting edge",
    also: "main edge",
    text: "The edge next to the nose that does most of the cutting. It cannot follow a wall steeper than itself.",
  },
  secondaryEdge: {
    name: "Secondary cutting edge",
    also: "secondary edge",
    text: "The edge behind the nose. On descending flanks it must stay clear of the part.",
  },
  edgeLength: {
    name: "Edge length (CUTLENGTH)",
    text: "Usable length of the edge. In a deeper pass the holder rubs. For thread tools: the tooth height.",
  },
  holder: {
    name: "Holder",
    text: "The tool body that carries the insert. It must touch neither the part nor the chuck.",
  },
  pass: {
    name: "Pass",
    text: "One roughing cut at one depth, from the infeed to the retraction.",
    // Also a verb.
    where: String.raw`(?!passes (?:the|through|by|over|without a)\b)`,
  },
  infeed: {
    name: "Infeed",
    text: "Depth of a pass relative to the previous one. Q463 is the maximum; the depth is divided evenly.",
  },
  roughing: { name: "Roughing", text: "Removing most of the material in few deep passes, down to the oversize." },
  finishing: {
    name: "Finishing",
    text: "One cut along the contour to the finished size, with a small depth and a small feed.",
  },
  setupClearance: {
    name: "Set-up clearance (Q460)",
    text: "Distance to the material for pre-positioning, and retraction distance before the return at rapid traverse.",
  },
  startPoint: {
    name: "Start point",
    text: "Position of the tool tip at the cycle call, clear of the material. The cycle begins and ends there.",
  },
  rapid: {
    name: "Rapid traverse",
    text: "The fastest movement of the axes. It must never touch material.",
    also: "rapid",
  },
  feedPerTurn: {
    name: "Feed per revolution (M136)",
    text: "Tool travel per spindle revolution. Chip thickness and surface are then independent of the speed.",
  },
  cuttingSpeed: {
    name: "Cutting speed",
    text:
      "Speed of the surface at the edge, m/min: π · ⌀ · n / 1000. VCONST keeps it constant while the diameter " +
      "changes.",
  },
  speedLimit: {
    name: "Speed limit (SMAX)",
    text: "The maximum spindle speed. Near the axis VCONST would require an infinite speed: chuck and part set the limit.",
  },
  chip: {
    name: "Chip",
    text: "The removed material. Its cross-section is depth times feed; force and power grow with it.",
  },
  cuttingForce: {
    name: "Specific cutting force (kc)",
    text: "Force per mm² of chip cross-section. It is higher for thin chips than for thick ones.",
  },
  roughness: {
    name: "Roughness (Rz)",
    text: "Height of the feed marks. The nose radius gives about f² / (8 · r): half the feed, a quarter of the height.",
  },
  gouge: { name: "Contour damage", text: "A cut into the finished part. It cannot be repaired." },
  airPass: { name: "Air pass", text: "A pass that touches no material." },
  plunging: {
    name: "Plunging",
    text:
      "Cutting into the material along a descending flank or straight down. Q487 allows plunging, Q488 is the " +
      "plunging feed.",
  },
  limit: {
    name: "Machining limit",
    text: "A diameter (Q480) or a Z position (Q482) beyond which the cycle does not cut the contour.",
  },
  program: {
    name: "Program",
    text: "The blocks that the control executes one after the other.",
    // Also a verb.
    where: String.raw`(?<!\b(?:to|you|can|must|not) )(?!program (?:it|the|this|these|both|each|every|everything|only|all)\b)`,
  },
  block: {
    name: "Block",
    text: "One numbered line of a program, or several that belong together, such as a cycle with its parameters.",
  },
  cycle: { name: "Cycle", text: "A machining operation of the control: a few values define all passes." },
  call: {
    name: "Cycle call",
    text: "M99, M89 or CYCL CALL. Only the call executes the defined cycle, with the current tool and start point.",
  },
  verdict: {
    name: "Check result",
    text: "Result of the program check: verified, errors found, or not fully simulated.",
  },
};
