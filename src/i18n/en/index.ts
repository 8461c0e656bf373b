import { first } from "./first.ts";
import { dialog } from "./dialog.ts";
import { setup } from "./setup.ts";
import { lathe } from "./lathe.ts";
import { help } from "./help.ts";
import { contour } from "./contour.ts";
import { editor } from "./editor.ts";
import { approach } from "./approach.ts";
import { findings } from "./findings.ts";
import { messages } from "./messages.ts";
import { operations } from "./operations.ts";
import { params } from "./params.ts";
import { cycles } from "./cycles.ts";

export const en = {
  ...first,
  dialog,
  setup,
  lathe,
  help,
  contour,
  editor,
  approach,
  findings,
  messages,
  operations,
  params,
  cycles,
};
