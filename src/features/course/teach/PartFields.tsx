import { outlinesFrom, PART_SOURCES, targetPartOfForm } from "../../../course/made/task-from-form.ts";
import type { Answer } from "../../../course/judge/judgement.ts";
import { isSameSize } from "../../../course/made/form-of-task.ts";
import { targetPart } from "../../../course/target-part.ts";
import { usualTable } from "../../../program/tools/cutting-table.ts";
import { sizeChoices } from "./size-choices.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { OutlineField } from "./OutlineField.tsx";
import { TeachText, type FormPart } from "./WordFields.tsx";

/** Blank and outlines of the target part, taken from the program or typed. */
export function PartFields({ made, change, answer }: FormPart & { readonly answer: Answer }) {
  const t = useTexts("course-teach");
  const { blank, outside, bore, threads } = made;
  // A selection is kept as long as the part still has it.
  const put = (part: Partial<Pick<typeof made, "blank" | "outside" | "bore">>, isStep = false) => {
    const offered = sizeChoices(targetPart(targetPartOfForm({ blank, outside, bore, threads, ...part })));
    change(
      { ...part, sizes: offered.map((size) => made.sizes.find((each) => isSameSize(each, size)) ?? size) },
      isStep,
    );
  };
  return (
    <fieldset>
      <legend>{t.part}</legend>
      <div className="teach-choices" role="group" aria-label={t.source}>
        <span className="soft">{t.source}</span>
        {PART_SOURCES.map((from) => (
          <button
            key={from}
            type="button"
            className="button"
            onClick={() => put(outlinesFrom(answer, from, threads), true)}
          >
            {t.sources[from]}
          </button>
        ))}
      </div>
      <TeachText
        label={t.blank}
        isNc
        rows={Math.max(2, blank.split("\n").length)}
        value={blank}
        change={(text) => put({ blank: text })}
      />
      <OutlineField label={t.outside} text={outside} change={(text) => put({ outside: text })} />
      <OutlineField label={t.bore} text={bore} change={(text) => put({ bore: text })} />
      <label className="teach-text">
        {t.material}
        <select
          className="select"
          value={made.material ?? ""}
          onChange={({ currentTarget: { value } }) => change({ material: value === "" ? null : value })}
        >
          <option value="">{t.anyMaterial}</option>
          {usualTable.materials.map(({ id, name }) => (
            <option key={id} value={id}>
              {name}
            </option>
          ))}
        </select>
      </label>
    </fieldset>
  );
}
