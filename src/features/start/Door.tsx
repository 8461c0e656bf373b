import { useId, type ReactNode } from "react";
import { Icon } from "../../app/base/Icon.tsx";

/** A way to start: one large button, and further ways below it. */
export function Door({
  name,
  how,
  go,
  children,
}: {
  readonly name: string;
  readonly how: string;
  readonly go: () => void;
  readonly children: ReactNode;
}) {
  const id = useId();
  return (
    <section className="door" aria-labelledby={id}>
      <button type="button" className="door-main" aria-labelledby={id} aria-describedby={`${id}how`} onClick={go}>
        <b id={id}>{name}</b>
        <span id={`${id}how`} className="soft">
          {how}
        </span>
        <Icon name="fold" />
      </button>
      <div className="door-ways small">{children}</div>
    </section>
  );
}
