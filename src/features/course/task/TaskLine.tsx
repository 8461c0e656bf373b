import { Suspense } from "react";
import { lazyPart } from "../../../app/base/parts.ts";
import { fetchShownTexts } from "../../../app/base/settings/use-texts.ts";
import { useEditor } from "../../../app/document/store.ts";

/** Loaded with the texts of the workplace when a task is open. */
const TaskBar = lazyPart(async () => {
  const [{ TaskBar: bar }] = await Promise.all([import("./TaskBar.tsx"), fetchShownTexts()]);
  return { default: bar };
});

/** The line of a task above its work. */
export function TaskLine() {
  const work = useEditor(({ job, program, work: key }) => ((job ?? program)?.task ? key : null));
  return (
    work !== null && (
      <Suspense>
        <TaskBar key={work} work={work} />
      </Suspense>
    )
  );
}
