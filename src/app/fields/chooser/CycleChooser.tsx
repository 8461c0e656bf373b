import { useTexts } from "../../base/settings/use-texts.ts";
import { useCycleChooser, type ChooserOptions } from "./use-cycle-chooser.tsx";

/** All cycles in the groups of the control, under a search. */
export function CycleChooser(options: ChooserOptions) {
  const { chooser: t } = useTexts("first");
  const { keys, search, found, recent, groups, others, startsWithOthers } = useCycleChooser(options);
  return (
    <div className={`cycle-chooser${options.narrow ? " narrow" : ""}`} role="group" aria-label={t.cycles} {...keys}>
      {search}
      {startsWithOthers && others}
      {found ?? (
        <>
          {recent}
          {groups}
        </>
      )}
      {!startsWithOthers && others}
    </div>
  );
}
