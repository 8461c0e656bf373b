import { useState } from "react";
import { goHome } from "../../app/document/go-home.ts";
import { Icon } from "../../app/base/Icon.tsx";
import type { WorkElsewhere } from "../../app/place/place.ts";
import { copyWork, takeOver, useSavedWorks } from "../../app/records/keep.ts";
import { freeName } from "../../app/records/works.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import "./works.css";

/** In place of a work that is open in another tab: the reason, and the ways to continue. */
export function OtherTabPage({ of: { work, name, cause } }: { readonly of: WorkElsewhere }) {
  const { elsewhere: t, works: list } = useTexts("device");
  const { page } = useTexts("first");
  const [taking, take] = useState(false);
  const over = async () => {
    take(true);
    await takeOver(work);
    take(false);
  };
  const copy = () =>
    copyWork(work, (now) =>
      freeName(
        now,
        useSavedWorks.getState().works.map((each) => each.name),
      ),
    );
  return (
    <main className="elsewhere-page">
      <h1>{cause === "isOpen" ? t.isOpen(name) : t.wasTaken(name)}</h1>
      <p>{cause === "isOpen" ? t.isOpenLead : t.wasTakenLead}</p>
      <ul>
        <li>
          <button
            type="button"
            className="button primary"
            disabled={taking}
            aria-describedby="elsewhere-take"
            onClick={() => void over()}
          >
            {cause === "isOpen" ? t.take : t.editAgain}
          </button>
          <span id="elsewhere-take" className="soft">
            {t.takeLong}
          </span>
        </li>
        <li>
          <button
            type="button"
            className="button"
            disabled={taking}
            aria-describedby="elsewhere-copy"
            onClick={() => void copy()}
          >
            {t.copy}
          </button>
          <span id="elsewhere-copy" className="soft">
            {t.copyLong}
          </span>
        </li>
        <li>
          <button type="button" className="button" onClick={goHome}>
            <Icon name="home" /> {list.back}
          </button>
          <a className="button" href="#/works">
            {page.works.title}
          </a>
        </li>
      </ul>
      <p role="status">{taking && t.taking}</p>
    </main>
  );
}
