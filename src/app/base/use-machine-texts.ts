import { loadMachine } from "../../i18n/load-machine.ts";
import { laterTexts } from "./settings/later-texts.ts";

/** Texts of machine data and of running times, in the screen language. */
export const { useThem: useMachineTexts, useThemSoon: useMachineTextsSoon } = laterTexts(loadMachine);
