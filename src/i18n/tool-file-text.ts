/** Texts of importing and exporting tool files, loaded with the tool table. */
export interface ToolFileTexts {
  readonly title: (files: string) => string;
  readonly fresh: (n: number) => string;
  readonly changed: (n: number) => string;
  readonly same: (n: number) => string;
  readonly wrong: (n: number) => string;
  readonly nothing: string;
  readonly more: (n: number) => string;
  readonly empty: string;
  readonly outline: string;
  readonly newOutline: string;
  readonly takeAll: (n: number) => string;
  readonly takeNew: (n: number) => string;
  readonly changeColumns: string;
  readonly cancel: string;
  /** Columns that the table does not show and the file preserves. */
  readonly keptInFile: (names: string) => string;
  readonly leftOut: (names: string) => string;
  readonly taken: (files: string, fresh: number, changed: number) => string;
  readonly export: string;
  readonly exportLong: string;
  readonly exportTitle: string;
  readonly again: (file: string) => string;
  readonly againHint: string;
  readonly againDone: (file: string, changed: number, added: number, removed: number) => string;
  readonly againShipped: (n: number) => string;
  readonly tooLong: (cells: string) => string;
  readonly notEncodable: string;
  readonly turning: string;
  readonly milling: string;
  readonly sheet: string;
  readonly json: string;
  readonly noHolders: string;
  readonly roundsHint: string;
  readonly sheetHint: string;
  readonly jsonHint: string;
  readonly noTools: string;
  readonly importLong: string;
  readonly notATable: (file: string) => string;
}
