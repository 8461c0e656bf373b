import type { ProposalReason, RefusalReason } from "../program/tool-files/facts.ts";
import type { ForeignFormat } from "../program/tool-files/formats.ts";

/** Texts about tools from files of other systems, loaded with the preview of an import. */
export interface ToolForeignTexts {
  readonly formats: Readonly<Record<ForeignFormat, string>>;
  readonly heading: (n: number, formats: string) => string;
  /** The unit of lengths: asked where the file has none. */
  readonly unit: string;
  readonly unitHint: string;
  readonly units: { readonly mm: string; readonly inch: string };
  readonly proposed: string;
  readonly proposedHint: string;
  readonly why: Readonly<Record<ProposalReason, string>>;
  readonly missing: (columns: string) => string;
  readonly flanks: (columns: string) => string;
  readonly taken: (n: number) => string;
  readonly unused: (properties: string) => string;
  /** Tools of the table whose numbers come with the files. */
  readonly replaces: (n: number) => string;
  readonly refused: (n: number) => string;
  readonly refusals: Readonly<Record<RefusalReason, (kind: string) => string>>;
  readonly column: string;
  readonly value: string;
  readonly property: string;
  readonly holder: string;
}
