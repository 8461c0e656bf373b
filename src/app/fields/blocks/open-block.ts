import { useMemo } from "react";
import type { Issue } from "../../../kernel/plan/issue.ts";
import type { Reading } from "../../../nc/reread.ts";
import type { Draft } from "../../../program/job/read-draft.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import type { FindingEntry } from "../../findings/entry.ts";
import type { JobReading } from "../../document/reading.ts";
import { useOwn } from "../../document/own-store.ts";
import { libraryOf, useOwnCycles } from "../../document/own-reading.ts";
import { readingOfOwn, type OwnBlock } from "./own-block.ts";
import { watchDraft } from "./half-typed.ts";
import { problemsOfBlock, readingOfBlock, withPrompt } from "./block-prompts.ts";
import { editProgram, useSession, type Session } from "./session.ts";
import { useShownOtherFile } from "../../document/shown-file.ts";
import { findingsShown } from "../../document/shown-findings.ts";
import { createDeferredStore } from "../../base/typing.ts";
import { enterSection, openPrompt } from "../../place/place.ts";

/** Text typed into the prompts of the open block. It is written to the program as soon as it can be read. */
interface Typed {
  readonly draft: Draft;
  /** The text state and block it was typed into; a later change of the text wins. */
  readonly reading: Reading | null;
  readonly index: number;
}

const useTyped = createDeferredStore<Typed>(() => ({ draft: {}, reading: null, index: -1 }));
const untyped: Draft = {};
const none: readonly Issue[] = [];
const draftIn = ({ draft, reading, index }: Typed, session: Session): Draft =>
  reading === session.reading && index === session.index ? draft : untyped;

/** The prompts of the open block with their texts; null for a cycle without a description. */
export function openPrompts(): { readonly ids: readonly string[]; readonly draft: Draft } | null {
  const session = useSession.getState();
  const {
    reading: { program },
    index,
  } = session;
  const typed = draftIn(useTyped.getState(), session);
  const read = readingOfBlock(program, index, typed);
  if (read) return { ids: Object.keys(read.cycle.params), draft: read.draft };
  const own = readingOfOwn(program, index, typed, libraryOf(useOwn.getState().list).cycles);
  return own && { ids: own.parameters.map(({ q }) => q), draft: own.draft };
}

/** The prompts of the open block and its problems, as a hook. */
export function useOpenBlock(): {
  readonly read: JobReading | null;
  readonly own: OwnBlock | null;
  readonly problems: readonly FindingEntry[];
} {
  const session = useSession();
  const draft = useTyped((typed) => draftIn(typed, session));
  const findings = useOutcome((s) => s.newest?.run.issues);
  const file = useShownOtherFile();
  const {
    reading: { program },
    index,
  } = session;
  const read = useMemo(() => readingOfBlock(program, index, draft), [program, index, draft]);
  const cycles = useOwnCycles();
  const own = useMemo(() => readingOfOwn(program, index, draft, cycles), [program, index, draft, cycles]);
  const issues = read?.reading.issues ?? own?.issues ?? none;
  const problems = useMemo(
    () => problemsOfBlock(program, index, issues, findingsShown(findings ?? [], file)),
    [program, index, issues, findings, file],
  );
  return { read, own, problems };
}

/** Stores the typed text with the text state that it led to. */
function noteTyped(draft: Draft, index: number): void {
  const { reading } = useSession.getState();
  useTyped.setState({ draft, reading, index });
  watchDraft(reading.program, index, draft);
}

/** Writes several prompts of the open block into its text, in one step. */
export function setBlockPrompts(texts: Readonly<Record<string, string>>): void {
  const session = useSession.getState();
  const {
    reading: { program },
    index,
  } = session;
  const draft = { ...draftIn(useTyped.getState(), session), ...texts };
  editProgram(
    Object.entries(texts).reduce((now, [q, text]) => withPrompt(now, index, q, text), program),
    null,
  );
  noteTyped(draft, index);
}

/** Writes a prompt of the open block into its text. */
export function setBlockPrompt(q: string, text: string): void {
  const session = useSession.getState();
  const {
    reading: { program },
    index,
  } = session;
  const draft = { ...draftIn(useTyped.getState(), session), [q]: text };
  editProgram(withPrompt(program, index, q, text), `block ${index} ${q}`);
  noteTyped(draft, index);
}

/** Opens the first prompt of the open block that still needs a value, or else its first prompt. */
export function openFirstOpenPrompt(): void {
  const session = useSession.getState();
  const read = readingOfBlock(session.reading.program, session.index, untyped);
  enterSection("block");
  if (!read) return;
  const ids = Object.keys(read.cycle.params);
  const id = ids.find((q) => read.reading.perField[q]?.issue) ?? ids[0];
  if (id !== undefined) openPrompt(id, read.draft[id] ?? "");
}
