import { Component, type ReactNode } from "react";
import { texts } from "./settings/loaded-texts.ts";
import { useSettings } from "./settings/settings.ts";

interface Props {
  /** What the row is called in its list. */
  readonly name: string;
  /** Number of cells, where the row is one of a table. */
  readonly columns?: number;
  readonly children: ReactNode;
}

/** A row of a list: one that cannot be shown is named, and the others stay. */
export class RowGuard extends Component<Props, { readonly failed: boolean }> {
  override state = { failed: false };

  static getDerivedStateFromError() {
    return { failed: true };
  }

  override render(): ReactNode {
    if (!this.state.failed) return this.props.children;
    const { name, columns } = this.props;
    const said = texts(useSettings.getState().language, "first").page.notice.rowUnreadable(name);
    return columns === undefined ? (
      <li className="soft">{said}</li>
    ) : (
      <tr>
        <td colSpan={columns}>{said}</td>
      </tr>
    );
  }
}
