import { approach } from "./approach.ts";
import { assignText } from "./assign-text.ts";
import { assign } from "./assign.ts";
import { blankBox } from "./blank-box.ts";
import { blankCylinder } from "./blank-cylinder.ts";
import { blankFile } from "./blank-file.ts";
import { blankRotation } from "./blank-rotation.ts";
import { call } from "./call.ts";
import { chamfer } from "./chamfer.ts";
import { contourDefinition } from "./contour-definition.ts";
import { contourFormula, declareContour } from "./contour-formula.ts";
import { cycleCall } from "./cycle-call.ts";
import { cycleLine } from "./cycle-line.ts";
import { cycle } from "./cycle.ts";
import { free } from "./free.ts";
import { functions } from "./functions.ts";
import { groove } from "./groove.ts";
import { jump } from "./jump.ts";
import { label } from "./label.ts";
import { mode } from "./mode.ts";
import { path } from "./path.ts";
import { plane } from "./plane.ts";
import { callProgram, callSelected, selectProgram } from "./program-calls.ts";
import { begin, end } from "./program-frame.ts";
import { raise } from "./raise.ts";
import { selectContour } from "./select-contour.ts";
import { spin } from "./spin.ts";
import { stop } from "./stop.ts";
import { comment, empty, structure, unknown } from "./text.ts";
import { toolCall } from "./tool-call.ts";
import { toolDefinition } from "./tool-definition.ts";
import { datum, datumTable, mirror, rotation, scale } from "./transforms.ts";
import { turnBlank } from "./turn-blank.ts";
import { turnCorrection } from "./turn-correction.ts";
import { undercut } from "./undercut.ts";

/** Every kind of block, in the order in which the palette offers them. */
export const blocks = [
  path,
  chamfer,
  approach,
  free,
  cycle,
  cycleCall,
  cycleLine,
  selectContour,
  undercut,
  groove,
  contourDefinition,
  declareContour,
  contourFormula,
  toolCall,
  spin,
  mode,
  turnCorrection,
  turnBlank,
  functions,
  toolDefinition,
  label,
  call,
  assign,
  assignText,
  jump,
  raise,
  callProgram,
  selectProgram,
  callSelected,
  stop,
  datum,
  datumTable,
  mirror,
  rotation,
  scale,
  plane,
  structure,
  comment,
  begin,
  blankCylinder,
  blankRotation,
  blankBox,
  blankFile,
  end,
  empty,
  unknown,
] as const;
