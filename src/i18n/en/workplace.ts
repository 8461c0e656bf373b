import type { Texts } from "../index.ts";
import { first } from "./first.ts";
import { dialog } from "./workplace/dialog.ts";
import { setup } from "./workplace/setup.ts";
import { lathe } from "./workplace/lathe.ts";
import { help } from "./workplace/help.ts";
import { contour } from "./workplace/contour.ts";
import { editor } from "./workplace/editor.ts";
import { approach } from "./workplace/approach.ts";
import { findings } from "./workplace/findings.ts";
import { messages } from "./workplace/messages.ts";
import { operations } from "./workplace/operations.ts";
import { params } from "./workplace/params.ts";
import { cycles } from "./workplace/cycles.ts";

export const workplace: Texts = {
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
