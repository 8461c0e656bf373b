import { Suspense, useState, type ReactNode } from "react";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { WhichButton } from "../../app/document/WhichButton.tsx";
import { CreateProgram } from "./CreateProgram.tsx";
import { Door } from "./Door.tsx";
import { OpenDoor } from "./OpenDoor.tsx";

/** The three ways to start: learn, program a cycle, open a program. */
export function Doors({ course, toCycles }: { readonly course: ReactNode; readonly toCycles: () => void }) {
  const {
    page: t,
    start: { doors },
  } = useTexts("first");
  const [creating, create] = useState(false);
  return (
    <nav className="doors" aria-label={doors.title}>
      <section className="door">
        <div className="course-place">
          <Suspense>{course}</Suspense>
        </div>
        <div className="door-ways small">
          <a className="door-way" href="#/guide">
            {doors.guide}
          </a>
          <a className="door-way" href="#/glossary">
            {doors.glossary}
          </a>
        </div>
      </section>
      <Door name={doors.program} how={doors.programHow} go={toCycles}>
        <WhichButton className="door-way" name={t.start.which} />
        <button type="button" className="door-way" onClick={() => create(true)}>
          {t.programs.create}
        </button>
        <a className="door-way" href="#/plan">
          {doors.plan}
        </a>
      </Door>
      <OpenDoor />
      {creating && <CreateProgram done={() => create(false)} />}
    </nav>
  );
}
