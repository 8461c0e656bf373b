import { Component, type ReactNode } from "react";
import { rememberWork } from "./saving/tab.ts";
import { firstTexts } from "./settings/loaded-texts.ts";
import { useSettings } from "./settings/settings.ts";

interface State {
  readonly crashed: boolean;
}

/** Keeps the work when the page itself fails: it is on the device already, and there is a way back to it. */
export class CrashGuard extends Component<{ readonly children: ReactNode }, State> {
  override state: State = { crashed: false };

  static getDerivedStateFromError(): State {
    return { crashed: true };
  }

  override render(): ReactNode {
    if (!this.state.crashed) return this.props.children;
    const t = firstTexts(useSettings.getState().language).page.notice;
    return (
      <main className="crash" role="alert">
        <h1>{t.crashTitle}</h1>
        <p>{t.crash}</p>
        <button type="button" className="button primary" onClick={() => location.reload()}>{t.reload}</button>
        <button type="button" className="button" onClick={() => {
          rememberWork(null);
          location.reload();
        }}>
          {t.startOver}
        </button>
      </main>
    );
  }
}
