import type { FirstTexts } from "../index.ts";
import { chooser } from "./first/chooser.ts";
import { helpMenu } from "./first/help.ts";
import { page } from "./first/page.ts";
import { start } from "./first/start.ts";
import { typeset } from "./typography/typeset.ts";

export const first: FirstTexts = typeset({ page, chooser, start, helpMenu });
