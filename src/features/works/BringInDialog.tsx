import { useEffect, useId, useRef, useState } from "react";
import type { DeviceTexts } from "../../i18n/en/device.ts";
import { goToWorks } from "../../app/document/go-home.ts";
import { Icon } from "../../app/base/Icon.tsx";
import type { ReadArchive } from "../../app/records/archive.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { endBringing, type Bringing } from "../../app/records/bring-in-place.ts";
import { bringsCourse } from "./bring-course.ts";
import { missingOwn, missingTools, statesOf, tablesHere, takeArchive, type ArchivedState, type TableChoice } from "./take-archive.ts";
import { useModal } from "../../app/base/use-modal.ts";
import "./works.css";

/** What is done with a table of the file: mine stays, takes what it does not have, or gives way. */
function TableWays({ name, missing, choice, t, onChoose }: { readonly name: string; readonly missing: number | null;
  readonly choice: TableChoice; readonly t: DeviceTexts["bringIn"]; readonly onChoose: (choice: TableChoice) => void })
{
  const id = useId();
  if (missing === null)
    return (
      <p>
        {name} · <span className="soft">{t.sameTable}</span>
      </p>
    );
  const ways: readonly (readonly [TableChoice, string])[] = [
    ["keep", t.keep],
    ...(missing > 0 ? [["missing", t.missing(missing)] as const] : []),
    ["replace", t.replace],
  ];
  return (
    <fieldset className="bring-table">
      <legend>{name}</legend>
      {ways.map(([way, words]) => (
        <label key={way}>
          <input type="radio" name={id} checked={choice === way} onChange={() => onChoose(way)} />
          <span>{words}</span>
        </label>
      ))}
    </fieldset>
  );
}

/** What a file holds, and what of it is taken. */
function Content({ archive, t, onDone }: { readonly archive: ReadArchive; readonly t: DeviceTexts["bringIn"];
  readonly onDone: (sentences: readonly string[]) => void })
{
  const { page, menu } = useTexts("first");
  const { works: list } = useTexts("device");
  const [states, setStates] = useState<readonly ArchivedState[] | null>(null);
  const [without, leave] = useState<ReadonlySet<number>>(new Set());
  const [tools, chooseTools] = useState<TableChoice>("keep");
  const [own, chooseOwn] = useState<TableChoice>("keep");
  const [settings, takeSettings] = useState(false);
  const [course, takeCourse] = useState(true);
  const [busy, work] = useState(false);
  const [here] = useState(tablesHere);
  useEffect(() => void statesOf(archive.works).then(setStates), [archive]);
  if (!states) return null;
  const toolsMissing = archive.tools && missingTools(archive.tools, here.tools);
  const ownMissing = archive.own && missingOwn(archive.own, here.own);
  const hasCourse = bringsCourse(archive, here.course);
  const isNew = (i: number) => states[i] !== "same";
  const chosen = archive.works.filter((_, i) => isNew(i) && !without.has(i));
  const fresh = archive.works.filter((_, i) => isNew(i)).length;
  const nothing = chosen.length === 0 && tools === "keep" && own === "keep" && !settings && !(hasCourse && course);
  const take = async () => {
    work(true);
    const { kept, full } = await takeArchive(archive, { works: chosen, tools, own, settings, course: hasCourse && course });
    onDone([
      ...(chosen.length > 0 ? [t.done(kept)] : []),
      ...(full > 0 ? [t.notKept(full)] : []),
      ...(tools !== "keep" || own !== "keep" || (hasCourse && course) ? [t.doneBeside] : []),
    ]);
  };
  return (
    <>
      {archive.works.length > 0 && (
        <fieldset className="bring-works">
          <legend>{t.works(archive.works.length)}</legend>
          {fresh === 0 && <p className="soft">{t.allSame}</p>}
          {fresh > 1 && (
            <label>
              <input type="checkbox" checked={without.size === 0} onChange={() =>
                leave(without.size === 0 ? new Set(archive.works.keys()) : new Set())} />
              <b>{t.all}</b>
            </label>
          )}
          <ul>
            {archive.works.map(({ job }, i) => (
              <li key={i}>
                <label>
                  <input type="checkbox" checked={isNew(i) && !without.has(i)} disabled={!isNew(i)} onChange={() =>
                    leave((before) => {
                      const next = new Set(before);
                      if (!next.delete(i)) next.add(i);
                      return next;
                    })} />
                  <span>
                    <b className="kept-name">{job.name}</b>{" "}
                    <span className="small">{"cycle" in job ? `${job.cycle} ${menu.of[job.cycle]?.name ?? ""}` : list.program}</span>{" "}
                    <span className="small soft">{t.states[states[i] ?? "fresh"]}</span>
                  </span>
                </label>
              </li>
            ))}
          </ul>
        </fieldset>
      )}
      {archive.tools && (
        <TableWays name={t.tools(archive.tools.length)} missing={toolsMissing?.length ?? null} choice={tools} t={t}
          onChoose={chooseTools} />
      )}
      {archive.own && archive.own.length > 0 && (
        <TableWays name={t.own(archive.own.length)} missing={ownMissing?.length ?? null} choice={own} t={t} onChoose={chooseOwn} />
      )}
      {archive.course && !hasCourse && (
        <p>
          {t.course} · <span className="soft">{t.sameTable}</span>
        </p>
      )}
      {hasCourse && (
        <label className="bring-settings">
          <input type="checkbox" checked={course} onChange={() => takeCourse(!course)} />
          <span>
            {t.course} <span className="small soft">{t.courseLong}</span>
          </span>
        </label>
      )}
      {archive.settings && (
        <label className="bring-settings">
          <input type="checkbox" checked={settings} onChange={() => takeSettings(!settings)} />
          <span>
            {t.settings} <span className="small soft">{t.settingsLong}</span>
          </span>
        </label>
      )}
      {archive.unread.length > 0 && (
        <p className="field-message warning">
          <Icon name="warning" /> <span>{t.unread(archive.unread.length, archive.unread.slice(0, 12).join(", "))}</span>
        </p>
      )}
      {archive.unreadParts.map((part) => (
        <p key={part} className="field-message warning">
          <Icon name="warning" /> <span>{t.unreadParts[part]}</span>
        </p>
      ))}
      <div className="bring-buttons">
        <button type="button" className="button primary" disabled={nothing || busy} onClick={() => void take()}>
          {nothing ? t.nothing : t.take}
        </button>
        <button type="button" className="button" onClick={endBringing}>{page.programs.cancel}</button>
      </div>
    </>
  );
}

/** Shows what a file of works holds before anything of it is taken. Nothing on the device is ever written over. */
export function BringInDialog({ of: { name, archive, problem } }: { readonly of: Bringing }) {
  const dialog = useRef<HTMLDialogElement>(null);
  useModal(dialog);
  const { bringIn: t } = useTexts("device");
  const { page } = useTexts("first");
  const [done, end] = useState<readonly string[] | null>(null);
  return (
    <dialog ref={dialog} className="bring-in" aria-label={t.title(name)} onKeyDown={(event) => event.stopPropagation()}
      onClose={() => !dialog.current?.open && endBringing()}
    >
      <h2>{t.title(name)}</h2>
      <p role="status">
        {problem !== null && (
          <>
            <Icon name="error" /> {t.problems[problem](name)}
          </>
        )}
        {done?.join(" ")}
      </p>
      {archive && !done && <Content archive={archive} t={t} onDone={end} />}
      {(problem !== null || done) && (
        <div className="bring-buttons">
          {done && (
            <button type="button" className="button primary" onClick={() => {
              endBringing();
              goToWorks();
            }}>
              {t.showAll}
            </button>
          )}
          <button type="button" className="button" onClick={endBringing}>{page.close}</button>
        </div>
      )}
    </dialog>
  );
}
