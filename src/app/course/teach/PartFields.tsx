import { outlinesFrom, PART_SOURCES, partOfMade } from "../../../course/made/made-task.ts";
import type { Answer } from "../../../course/judge/judgement.ts";
import { wantedPart } from "../../../course/wanted-part.ts";
import { sizeChoices } from "./size-choices.ts";
import { useTeachTexts } from "./use-teach-texts.ts";
import { TeachText, type FormPart } from "./WordFields.tsx";

/** Blank and outlines of the wanted part, taken from the program or typed. */
export function PartFields({ made, change, answer }: FormPart & { readonly answer: Answer }) {
  const t = useTeachTexts();
  const { blank, outside, bore } = made;
  // What was chosen stays chosen as long as the part still has it.
  const put = (part: Partial<Pick<typeof made, "blank" | "outside" | "bore">>) => {
    const next = { blank, outside, bore, ...part };
    const sizes = sizeChoices(wantedPart(partOfMade(next))).map((size) =>
      made.sizes.find(({ kind, at, nominal }) => kind === size.kind && at === size.at && nominal === size.nominal) ?? size
    );
    change({ ...part, sizes });
  };
  const rows = (text: string) => Math.min(12, Math.max(2, text.split("\n").length));
  return (
    <fieldset>
      <legend>{t.part}</legend>
      <div className="teach-choices" role="group" aria-label={t.source}>
        <span className="soft">{t.source}</span>
        {PART_SOURCES.map((from) => (
          <button key={from} type="button" className="button" onClick={() => put(outlinesFrom(answer, from))}>{t.sources[from]}</button>
        ))}
      </div>
      <TeachText label={t.blank} isNc rows={rows(blank)} value={blank} change={(text) => put({ blank: text })} />
      <TeachText label={t.outside} hint={t.partHint} isNc rows={rows(outside)} value={outside} change={(text) => put({ outside: text })} />
      <TeachText label={t.bore} isNc rows={rows(bore)} value={bore} change={(text) => put({ bore: text })} />
    </fieldset>
  );
}
