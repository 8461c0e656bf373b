import { Component, type ErrorInfo, type ReactNode } from "react";
import { noteFault } from "../app/records/reports.ts";
import { lazyPart } from "../app/base/parts.ts";
import { unsavedWorks } from "../app/records/keep.ts";
import { noteBroken } from "../app/records/opening.ts";
import { rememberWork } from "../app/records/tab.ts";
import { useEditor } from "../app/document/store.ts";
import { texts } from "../app/base/settings/loaded-texts.ts";
import { useSettings } from "../app/base/settings/settings.ts";
import { fetchCrashHelp } from "../features/works/index.ts";

interface State {
  readonly crashed: boolean;
}

/** It may fail to load, above all after an error of the page: the page does without. */
const CrashHelp = lazyPart(async () => ({ default: (await fetchCrashHelp()).CrashHelp }));

/** Shows nothing where its content fails. */
class SilentBoundary extends Component<{ readonly children: ReactNode }, State> {
  override state: State = { crashed: false };

  static getDerivedStateFromError(): State {
    return { crashed: true };
  }

  override render(): ReactNode {
    return this.state.crashed ? null : this.props.children;
  }
}

/** Reloads at the start page, whatever the address says: the open work may be the cause. */
function startOver(): void {
  rememberWork(null);
  history.replaceState(null, "", `${location.pathname}${location.search}#/`);
  location.reload();
}

/** Offers a way back to the work after an error of the page: the work is already saved on the device. */
export class CrashGuard extends Component<{ readonly children: ReactNode }, State> {
  override state: State = { crashed: false };

  static getDerivedStateFromError(): State {
    return { crashed: true };
  }

  override componentDidCatch(error: unknown, { componentStack }: ErrorInfo): void {
    const { work } = useEditor.getState();
    if (work !== null) noteBroken(work);
    noteFault(error, componentStack ?? "");
  }

  override render(): ReactNode {
    if (!this.state.crashed) return this.props.children;
    const t = texts(useSettings.getState().language, "first").page.notice;
    return (
      <main className="crash">
        <div role="alert">
          <h1>{t.crashTitle}</h1>
          <p>{unsavedWorks().length > 0 ? t.notKept : t.crash}</p>
        </div>
        <button type="button" className="button primary" onClick={() => location.reload()}>
          {t.reload}
        </button>
        <button type="button" className="button" onClick={startOver}>
          {t.startOver}
        </button>
        <SilentBoundary>
          <CrashHelp />
        </SilentBoundary>
      </main>
    );
  }
}
