import { useState } from "react";
import { LongList } from "../../app/base/LongList.tsx";
import { Icon } from "../../app/base/Icon.tsx";
import { downloadText } from "../../app/base/download.ts";
import { asideRows, forgetAside } from "../../app/base/set-aside.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { forgetUnread, readUnread } from "../../app/records/device.ts";
import { refreshWorks, useSavedWorks } from "../../app/records/keep.ts";

/** Data that cannot be read, with the ways to keep or to delete them. */
interface UnreadEntry {
  readonly key: string;
  readonly name: string;
  readonly isNewer: boolean;
  readonly read: () => Promise<unknown>;
  readonly remove: () => Promise<unknown>;
}

/** Data of any kind as text: JSON, where a value that JSON lacks, or that contains itself, is named instead. */
function anyText(raw: unknown): string {
  const around: unknown[] = [];
  const value = function (this: unknown, _: string, each: unknown): unknown {
    if (typeof each === "bigint") return String(each);
    if (typeof each !== "object" || each === null) return each;
    around.splice(around.indexOf(this) + 1);
    if (around.includes(each)) return "…";
    around.push(each);
    return each;
  };
  return JSON.stringify(raw, value, 1) ?? "";
}

/** What cannot be read on this device: programs and rows of its tables. Nothing of it is deleted by itself. */
export function UnreadList() {
  const { works: t } = useTexts("device");
  const saves = useSavedWorks((k) => k.unread);
  const [rows, look] = useState(asideRows);
  const all: readonly UnreadEntry[] = [
    ...saves.map((save) => ({
      key: `${save.store} ${save.key}`,
      name: save.name,
      isNewer: save.isNewer,
      read: () => readUnread(save),
      remove: () => forgetUnread(save).then(refreshWorks),
    })),
    ...rows.map((row) => ({
      key: `${row.record} ${row.at} ${row.name}`,
      name: row.name,
      isNewer: false,
      read: () => Promise.resolve(row.raw),
      remove: async () => {
        forgetAside(row);
        look(asideRows());
      },
    })),
  ];
  if (all.length === 0) return null;
  return (
    <section className="unread" aria-label={t.unread.title}>
      <h2>{t.unread.title}</h2>
      <p className="soft">{t.unread.lead}</p>
      <LongList
        all={all}
        more={t.more}
        className="works-list"
        row={({ key, name, isNewer, read, remove }) => (
          <li key={key} className="work-row">
            <span className="unread-words">
              <b className="kept-name">{name}</b>
              <span className="small soft">{isNewer ? t.unread.newer : t.unread.damaged}</span>
            </span>
            <div className="work-tools">
              <button
                type="button"
                className="button icon plain"
                aria-label={t.unread.save(name)}
                title={t.unread.save(name)}
                onClick={() =>
                  void read().then((raw) => downloadText(anyText(raw), `${name.replace(/[\\/:*?"<>|]+/g, "-")}.json`))
                }
              >
                <Icon name="download" />
              </button>
              <button
                type="button"
                className="button icon plain"
                aria-label={t.remove(name)}
                title={t.remove(name)}
                onClick={() => void remove()}
              >
                <Icon name="remove" />
              </button>
            </div>
          </li>
        )}
      />
    </section>
  );
}
