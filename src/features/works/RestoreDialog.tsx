import { useEffect, useId, useState } from "react";
import { nameOfWork } from "../../app/records/device.ts";
import type { DeviceTexts } from "../../i18n/en/device.ts";
import { goToEntrance } from "../../app/document/go-home.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { Message } from "../../app/base/Message.tsx";
import type { ReadArchive } from "../../app/records/archive.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { closeRestore, type PendingRestore } from "../../app/records/pending-restore.ts";
import { BOXES, TABLES } from "../../app/records/parts.ts";
import { LongWait } from "../../app/calculation/LongWait.tsx";
import { LongList } from "../../app/base/LongList.tsx";
import {
  boxOffer,
  DEFAULT_CHOICES,
  statesOf,
  tableOffer,
  restoreArchive,
  type ArchivedState,
  type GroupChoice,
} from "./restore-archive.ts";
import { ModalDialog } from "../../app/base/ModalDialog.tsx";
import "./works.css";

/** What happens to a table: mine stays, gets the missing rows, or is replaced. */
function TableWays({
  name,
  missing,
  choice,
  t,
  onChoose,
}: {
  readonly name: string;
  readonly missing: number;
  readonly choice: GroupChoice;
  readonly t: DeviceTexts["restore"];
  readonly onChoose: (choice: GroupChoice) => void;
}) {
  const id = useId();
  const ways: readonly (readonly [GroupChoice, string])[] = [
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

function SameAsHere({ name, t }: { readonly name: string; readonly t: DeviceTexts["restore"] }) {
  return (
    <p>
      {name} · <span className="soft">{t.sameTable}</span>
    </p>
  );
}

const BOX_NAMES = Object.keys(BOXES) as readonly (keyof typeof BOXES)[];

/** The contents of a backup, and the choice what to restore. */
function Content({
  archive,
  t,
  onDone,
}: {
  readonly archive: ReadArchive;
  readonly t: DeviceTexts["restore"];
  readonly onDone: (sentences: readonly string[]) => void;
}) {
  const { page, menu } = useTexts("first");
  const { works: list } = useTexts("device");
  const [states, setStates] = useState<readonly ArchivedState[] | null>(null);
  const [without, leave] = useState<ReadonlySet<number>>(new Set());
  const [choices, choose] = useState(DEFAULT_CHOICES);
  const [busy, work] = useState(false);
  const [tables] = useState(() => TABLES.map((group) => ({ group, offer: tableOffer(archive, group) })));
  const [boxes] = useState(() => BOX_NAMES.map((group) => ({ group, offer: boxOffer(archive, group) })));
  useEffect(() => void statesOf(archive.works).then(setStates), [archive]);
  if (!states) return <LongWait>{page.readingDevice}</LongWait>;
  const isNew = (i: number) => states[i] !== "same";
  const chosen = archive.works.filter((_, i) => isNew(i) && !without.has(i));
  const fresh = archive.works.filter((_, i) => isNew(i)).length;
  const long = { course: t.courseLong, settings: t.settingsLong };
  const offered = [
    ...tables.filter(({ offer }) => offer && offer.missing !== null),
    ...boxes.filter(({ offer }) => offer),
  ];
  const nothing = chosen.length === 0 && offered.every(({ group }) => choices[group] === "keep");
  const take = async () => {
    work(true);
    const { kept, full, undone } = await restoreArchive(archive, chosen, choices);
    onDone([
      ...(chosen.length > 0 ? [t.done(kept)] : []),
      ...(full > 0 ? [t.notKept(full)] : []),
      ...(undone ? [t.doneBeside] : []),
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
              <input
                type="checkbox"
                checked={without.size === 0}
                onChange={() => leave(without.size === 0 ? new Set(archive.works.keys()) : new Set())}
              />
              <b>{t.all}</b>
            </label>
          )}
          <LongList
            all={archive.works}
            more={list.more}
            row={({ job }, i) => (
              <li key={i}>
                <label>
                  <input
                    type="checkbox"
                    checked={isNew(i) && !without.has(i)}
                    disabled={!isNew(i)}
                    onChange={() =>
                      leave((before) => {
                        const next = new Set(before);
                        if (!next.delete(i)) next.add(i);
                        return next;
                      })
                    }
                  />
                  <span>
                    <b className="kept-name">{nameOfWork(job)}</b>{" "}
                    <span className="small">
                      {"cycle" in job ? `${job.cycle} ${menu.of[job.cycle]?.name ?? ""}` : list.program}
                    </span>{" "}
                    <span className="small soft">{t.states[states[i] ?? "fresh"]}</span>
                  </span>
                </label>
              </li>
            )}
          />
        </fieldset>
      )}
      {tables.map(
        ({ group, offer }) =>
          offer &&
          (offer.missing === null ? (
            <SameAsHere key={group} name={t[group](offer.rows)} t={t} />
          ) : (
            <TableWays
              key={group}
              name={t[group](offer.rows)}
              missing={offer.missing}
              choice={choices[group]}
              t={t}
              onChoose={(choice) => choose({ ...choices, [group]: choice })}
            />
          )),
      )}
      {boxes.map(
        ({ group, offer }) =>
          offer !== null &&
          (offer ? (
            <label key={group} className="bring-settings">
              <input
                type="checkbox"
                checked={choices[group] !== "keep"}
                onChange={() => choose({ ...choices, [group]: choices[group] === "keep" ? "missing" : "keep" })}
              />
              <span>
                {t[group]} <span className="small soft">{long[group]}</span>
              </span>
            </label>
          ) : (
            <SameAsHere key={group} name={t[group]} t={t} />
          )),
      )}
      {archive.unread.length > 0 && (
        <Message tone="warning">{t.unread(archive.unread.length, archive.unread.slice(0, 12).join(", "))}</Message>
      )}
      {archive.unreadRows.length > 0 && (
        <Message tone="warning">
          {t.unreadRows(archive.unreadRows.length, archive.unreadRows.slice(0, 12).join(", "))}
        </Message>
      )}
      {archive.unreadParts.map((part) => (
        <Message key={part} tone="warning">
          {t.unreadParts[part]}
        </Message>
      ))}
      {busy && <LongWait>{t.busy}</LongWait>}
      <div className="bring-buttons">
        <button type="button" className="button primary" disabled={nothing || busy} onClick={() => void take()}>
          {nothing ? t.nothing : t.take}
        </button>
        <button type="button" className="button" onClick={closeRestore}>
          {page.programs.cancel}
        </button>
      </div>
    </>
  );
}

/** Shows the contents of a backup before anything is restored. Works on the device are never overwritten. */
export function RestoreDialog({ of: { name, archive, problem } }: { readonly of: PendingRestore }) {
  const { restore: t } = useTexts("device");
  const { page } = useTexts("first");
  const [done, end] = useState<readonly string[] | null>(null);
  return (
    <ModalDialog isBare className="bring-in" title={t.title(name)} done={closeRestore}>
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
            <button
              type="button"
              className="button primary"
              onClick={() => {
                closeRestore();
                goToEntrance({ page: "works" });
              }}
            >
              {t.showAll}
            </button>
          )}
          <button type="button" className="button" onClick={closeRestore}>
            {page.close}
          </button>
        </div>
      )}
    </ModalDialog>
  );
}
