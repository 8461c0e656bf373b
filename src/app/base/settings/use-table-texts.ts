import { loadTables } from "../../../i18n/load-tables.ts";
import { laterTexts } from "./later-texts.ts";

/** What the tables of the device say, tools and own cycles, in the screen language. */
export const { useThem: useTableTexts, provide: provideTableTexts } = laterTexts(loadTables);
