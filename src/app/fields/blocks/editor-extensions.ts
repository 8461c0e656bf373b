import { completionKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, history } from "@codemirror/commands";
import { lintGutter, lintKeymap } from "@codemirror/lint";
import { Compartment, EditorState, type Extension } from "@codemirror/state";
import { EditorView, highlightSpecialChars, keymap } from "@codemirror/view";
import type { Texts } from "../../../i18n/index.ts";
import type { Language } from "../../../i18n/languages.ts";
import { guardCopy } from "../leaving/whole-program.ts";
import { KEEPS_KEYBOARD } from "../../place/place.ts";
import { blockMarks } from "./block-marks.ts";
import { foundMarks } from "../find/found-marks.ts";
import { cycleHelp } from "./cycle-help.ts";
import { cycleFolding, FOLDED_PHRASE } from "./folding.ts";
import { HIDDEN_PHRASE, longLines } from "./long-lines.ts";
import { klartext } from "./nc-language.ts";
import { readingField } from "./reading-field.ts";

/** Intercepts copy and cut when the selection is the whole program and it has faults. */
const holdBack = (event: ClipboardEvent, { state }: EditorView): boolean =>
  guardCopy(event, state.selection.ranges.map((range) => state.sliceDoc(range.from, range.to)).join("\n"));

/** Extensions that depend on the screen language. */
const inLanguage = new Compartment();

const worded = (t: Texts, language: Language): Extension => [
  cycleHelp(t, language),
  EditorView.contentAttributes.of({
    "aria-label": t.page.text.title,
    tabindex: "0",
    spellcheck: "false",
    autocapitalize: "characters",
    autocorrect: "off",
  }),
  EditorState.phrases.of({
    Diagnostics: t.findings.title,
    "No diagnostics": t.findings.none,
    close: t.page.close,
    [FOLDED_PHRASE]: t.editor.parameters,
    [HIDDEN_PHRASE]: t.editor.hiddenCharacters,
    "Fold line": t.editor.fold,
    "Unfold line": t.editor.unfold,
  }),
];

/** Switches hover help, completion and names to a screen language. */
export const inWords = (t: Texts, language: Language) => inLanguage.reconfigure(worded(t, language));

/**
 * All extensions of the text editor. It binds no undo keys: those of the page use the same history. `mixedEnds`: line
 * ends differ, so carriage returns stay characters of their lines.
 */
export const editorExtensions = (mixedEnds: boolean): Extension => [
  ...(mixedEnds ? [EditorState.lineSeparator.of("\n")] : []),
  readingField,
  klartext,
  longLines,
  blockMarks,
  foundMarks,
  cycleFolding,
  lintGutter(),
  EditorView.lineWrapping,
  history({ minDepth: 1000 }),
  highlightSpecialChars(),
  inLanguage.of([]),
  keymap.of([...completionKeymap, ...lintKeymap, ...defaultKeymap]),
  EditorView.domEventHandlers({ copy: holdBack, cut: holdBack }),
  EditorView.editorAttributes.of({ [KEEPS_KEYBOARD]: "" }),
];
