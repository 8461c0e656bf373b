import type { CodeNote } from "../program/iso-codes/code-cells.ts";
import type { BarMake, InsertClamping, Cuts, Hand, PartName } from "../program/iso-codes/code-part.ts";
import type { Breaker, EdgeFinish, Hole, InsertForm } from "../program/iso-codes/insert-facts.ts";
import type { NotCovered } from "../program/iso-codes/tool-code.ts";

type Named<K extends string> = Readonly<Record<K, string>>;
type NotesOf<N, V> = { readonly [K in Extract<CodeNote, N>["is"]]: V };

/** Texts of the reading of tool codes, loaded with the tool table. Numbers arrive as formatted for the screen. */
export interface ToolCodeTexts {
  readonly label: string;
  readonly hint: string;
  readonly says: string;
  readonly fills: string;
  readonly take: string;
  readonly nothing: string;
  readonly taken: (code: string, n: number) => string;
  readonly readName: (code: string) => string;
  readonly empty: string;
  /** Placeholder for the corners of a head. */
  readonly outline: string;
  readonly newOutline: string;
  readonly notCovered: Named<NotCovered>;
  readonly unknownPart: string;
  readonly unsure: string;
  readonly part: (part: string, said: string) => string;
  readonly parts: Named<PartName>;
  readonly forms: Named<InsertForm>;
  readonly holes: Named<Hole>;
  readonly breakers: Named<Breaker>;
  readonly finishes: Named<EdgeFinish>;
  readonly hands: Named<Hand>;
  readonly clampings: Named<InsertClamping>;
  readonly makes: Named<BarMake>;
  readonly cuts: Named<Cuts>;
  readonly sides: Named<"outside" | "inside" | "both">;
  readonly perInch: (n: string) => string;
  readonly special: string;
  readonly angle: (n: string) => string;
  readonly mm: (n: string) => string;
  readonly tolerance: (circle: string, thickness: string) => string;
  readonly wiper: (angle: string | null) => string;
  readonly notes: NotesOf<{ readonly insert: string }, (insert: string, holder: string) => string> &
    NotesOf<{ readonly row: number }, (row: string, code: string) => string> &
    Named<
      | "inch"
      | "inchHolder"
      | "cornerMissing"
      | "sizeUnsure"
      | "onlyCorner"
      | "endCutting"
      | "leftBar"
      | "headDrawn"
      | "special"
      | "fullRadius"
      | "unverified"
      | "flanksDiffer"
      | "holderUnplaced"
    > & {
      readonly frontAngle: (angle: string) => string;
      readonly unsure: (letter: string, angle: string) => string;
      readonly noShank: Named<"seat" | "reach" | "round">;
    };
}
