/** Texts of sheets of tools whose columns are assigned, loaded when such a sheet is imported. */
export interface SheetTexts {
  readonly title: (file: string) => string;
  readonly lead: string;
  readonly columns: string;
  readonly column: (title: string) => string;
  readonly untitled: (place: number) => string;
  readonly examples: (values: string) => string;
  readonly noExamples: string;
  readonly meaning: (title: string) => string;
  readonly unused: string;
  readonly code: string;
  readonly reading: (title: string) => string;
  readonly readings: {
    readonly mm: string;
    readonly inch: string;
    readonly radius: (unit: string) => string;
    readonly diameter: (unit: string) => string;
  };
  readonly twice: (cell: string) => string;
  readonly words: Readonly<Record<"TYPE" | "TO", string>>;
  readonly wordOf: (word: string) => string;
  readonly noValue: string;
  readonly notUsed: (titles: string) => string;
  readonly tools: (n: number) => string;
  readonly withErrors: (n: number) => string;
  readonly line: (line: number) => string;
  readonly twiceNumbered: (numbers: string) => string;
  readonly proposedNumber: string;
  readonly empty: string;
  readonly again: string;
  readonly go: string;
  readonly cancel: string;
  readonly asOn: (day: string) => string;
  readonly numbered: (numbers: string) => string;
  readonly paste: string;
  readonly pasteLong: string;
  readonly pasted: string;
  readonly noPaste: string;
}
