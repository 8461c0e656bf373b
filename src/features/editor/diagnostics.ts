import { setDiagnostics, type Diagnostic } from "@codemirror/lint";
import type { EditorState, Transaction, TransactionSpec } from "@codemirror/state";
import type { EditorView } from "@codemirror/view";
import type { Texts } from "../../i18n/index.ts";
import type { Lengths } from "../../i18n/lengths.ts";
import { blockAt } from "../../nc/reread.ts";
import type { RunFinding } from "../../program/state/run-types.ts";
import { issueText, placeInFile } from "../../app/calculation/issue-text.ts";
import { readingField } from "../../app/fields/blocks/reading-field.ts";

/** Limit of marks: more would add nothing. */
const MOST = 1500;

type Found = Pick<RunFinding, "issue" | "line"> & { readonly inFile?: RunFinding["inFile"] | undefined };

/** The range of a finding in the editor's text. */
export function placeOf(
  state: EditorState,
  { issue, line, inFile }: Found,
): { readonly from: number; readonly to: number } | null {
  if (line === null || line < 1 || line > state.doc.lines) return null;
  const at = state.doc.line(line);
  if ("column" in issue && !inFile) {
    const from = Math.min(at.to, at.from + issue.column - 1);
    return { from, to: Math.min(at.to, from + issue.length) };
  }
  return { from: at.from + at.text.search(/\S|$/), to: at.to };
}

/** The correction that a finding of the reader offers, in the editor's text; null without one. */
export function fixOf(state: EditorState, finding: Found): TransactionSpec | null {
  const { issue } = finding;
  const place = placeOf(state, finding);
  if (!place || finding.inFile || !("fix" in issue) || !issue.fix) return null;
  const from = place.from + issue.fix.offset - issue.offset;
  const to = from + issue.fix.length;
  return from < 0 || to > state.doc.length
    ? null
    : { changes: { from, to, insert: issue.fix.text }, userEvent: "input.fix" };
}

/** Cycle whose definition contains a finding: determines what the value at that place measures. */
export function cycleOf(state: EditorState, offset: number): number | null {
  const reading = state.field(readingField);
  const s = reading.program.blocks[blockAt(reading, offset)]?.statement;
  return s?.kind === "cycle" ? s.cycle : null;
}

/** Marks all findings in text and margin, with their sentences in the screen language and what corrects them. */
export function diagnosticsOf(
  view: EditorView,
  findings: readonly RunFinding[],
  t: Texts,
  lengths: Lengths,
  dispatch: (spec: TransactionSpec) => void,
): Pick<Transaction, "effects"> & TransactionSpec {
  const { state } = view;
  const all: Diagnostic[] = [];
  for (const finding of findings.slice(0, MOST)) {
    const place = placeOf(state, finding);
    if (!place) continue;
    const fix = fixOf(state, finding);
    const said = issueText(t, lengths, finding.issue, cycleOf(state, place.from));
    all.push({
      ...place,
      severity: finding.issue.severity,
      message: finding.inFile ? `${placeInFile(t, finding.inFile)}: ${said}` : said,
      ...(fix && {
        actions: [
          {
            name: t.findings.fix,
            apply: () => {
              const now = fixOf(view.state, finding);
              if (now) dispatch(now);
            },
          },
        ],
      }),
    });
  }
  return setDiagnostics(
    state,
    all.sort((a, b) => a.from - b.from),
  ) as Pick<Transaction, "effects"> & TransactionSpec;
}
