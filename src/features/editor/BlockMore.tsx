import { LazyPromptMore } from "../../app/fields/said/LazyPromptMore.tsx";
import { useGuidedBlock } from "../../app/place/open-call.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { useEditor } from "../../app/document/store.ts";
import type { BlockKind } from "../../nc/blocks/names.ts";
import type { WordField } from "../../app/fields/blocks/field.ts";

interface Props {
  readonly kind: BlockKind;
  readonly field: WordField;
  /** The line of its block, from 1. */
  readonly line: number;
}

/** Kinds whose guide page covers all their words. */
const KINDS_WITH_ONE_PAGE: ReadonlySet<string> = new Set(["text", "parameter"]);

/** The link from a field of a block to its page of the guide. */
export function BlockMore({ kind, field: { id, name }, line }: Props) {
  const { editor: t } = useTexts();
  const work = useEditor((s) => s.work);
  const word = id.replace(/^word /, "");
  const page = KINDS_WITH_ONE_PAGE.has(word) || kind === "cycle" ? kind : `${kind}.${word}`;
  return (
    <span className="block-more" onClickCapture={() => useGuidedBlock.setState({ block: { work, line, word: id } })}>
      <LazyPromptMore page={["guide", "block", page]} name={typeof name === "string" ? t.fields[name] : name.word} />
    </span>
  );
}
