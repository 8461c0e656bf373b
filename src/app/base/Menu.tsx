import { useId, useLayoutEffect, useRef, useState, type KeyboardEvent, type ReactNode } from "react";
import { Icon, type IconName } from "./Icon.tsx";
import "./menu.css";

export interface MenuItem {
  readonly name: string;
  readonly icon?: IconName;
  /** Longer explanation, as tooltip. */
  readonly hint?: string;
  /** Opens a dialog. */
  readonly opens?: "dialog";
  /** Its shortcut. */
  readonly shortcut?: string;
  readonly go: () => void;
}

/** An item that leads to an address. */
export interface MenuLink extends Pick<MenuItem, "name" | "icon" | "hint"> {
  readonly href: string;
}

interface Props {
  readonly name: string;
  readonly groups: readonly (readonly (MenuItem | MenuLink)[])[];
  /** What the button shows instead of its name and an arrow. */
  readonly label?: ReactNode;
  /** Tooltip of the button. */
  readonly hint?: string;
  readonly className?: string;
}

/** Space between button and list, CSS pixels. */
const GAP = 4;

/** Shows the list beside its button, in the top layer: above it if there is more room, and within the window. */
function place(list: HTMLElement, { left, right, top, bottom }: DOMRect): void {
  list.showPopover?.();
  const [width, height] = [list.offsetWidth, list.offsetHeight];
  const begin = left + width + GAP > innerWidth ? right - width : left;
  const under = bottom + GAP + height <= innerHeight || bottom + top < innerHeight;
  list.style.left = `${Math.max(GAP, begin)}px`;
  list.style.top = `${Math.max(GAP, under ? bottom + GAP : top - GAP - height)}px`;
}

/** The item that a key goes to: by arrows, to the ends, or by its first letter. */
export function itemByKey(key: string, at: number, names: readonly string[]): number | null {
  const all = names.length;
  switch (key) {
    case "ArrowDown":
      return (at + 1) % all;
    case "ArrowUp":
      return (Math.max(at, 0) + all - 1) % all;
    case "Home":
      return 0;
    case "End":
      return all - 1;
    default: {
      if ([...key].length !== 1) return null;
      const order = names.map((_, i) => (at + 1 + i) % all);
      return order.find((i) => names[i]?.toLowerCase().startsWith(key.toLowerCase())) ?? null;
    }
  }
}

function Item({ item, close }: { readonly item: MenuItem | MenuLink; readonly close: () => void }) {
  const own = { role: "menuitem", className: "menu-item", tabIndex: -1, title: item.hint };
  const content = (
    <>
      {item.icon && <Icon name={item.icon} />}
      <span>{item.name}</span>
      {"shortcut" in item && <kbd>{item.shortcut}</kbd>}
    </>
  );
  if ("href" in item)
    return (
      <a {...own} href={item.href} onClick={close}>
        {content}
      </a>
    );
  const act = () => {
    close();
    item.go();
  };
  return (
    <button {...own} type="button" aria-haspopup={item.opens} onClick={act}>
      {content}
    </button>
  );
}

/** A button with a menu of actions and links, in groups. */
export function Menu({ name, groups, label, hint, className = "button menu-button" }: Props) {
  const id = useId();
  const [open, setOpen] = useState(false);
  const button = useRef<HTMLButtonElement>(null),
    list = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    if (!open || !list.current || !button.current) return undefined;
    place(list.current, button.current.getBoundingClientRect());
    list.current.querySelector<HTMLElement>("[role=menuitem]")?.focus();
    const close = () => setOpen(false);
    addEventListener("resize", close);
    return () => removeEventListener("resize", close);
  }, [open]);
  /** Closes before the list leaves the page, so that the focus is never lost. */
  const close = () => {
    button.current?.focus();
    setOpen(false);
  };
  const pressKey = (event: KeyboardEvent) => {
    event.stopPropagation();
    if (event.key === "Escape" || event.key === "Tab") {
      if (event.key === "Escape") event.preventDefault();
      return close();
    }
    const items = [...(list.current?.querySelectorAll<HTMLElement>("[role=menuitem]") ?? [])];
    const at = items.indexOf(document.activeElement as HTMLElement);
    const next = itemByKey(
      event.key,
      at,
      items.map((item) => item.textContent.trim()),
    );
    if (next === null || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    items[next]?.focus();
  };
  return (
    <>
      <button
        ref={button}
        type="button"
        className={className}
        aria-label={label === undefined ? undefined : name}
        title={hint}
        aria-haspopup="menu"
        aria-expanded={open}
        aria-controls={open ? id : undefined}
        onPointerDown={(event) => open && event.preventDefault()}
        onClick={() => (open ? close() : setOpen(true))}
        onKeyDown={(event) => {
          if (event.key !== "ArrowDown" || open) return;
          event.preventDefault();
          setOpen(true);
        }}
      >
        {label ?? (
          <>
            {name} <Icon name="down" />
          </>
        )}
      </button>
      {open && (
        <div
          ref={list}
          id={id}
          className="menu"
          popover="manual"
          role="menu"
          aria-label={name}
          onKeyDown={pressKey}
          onBlur={({ relatedTarget, currentTarget }) => {
            if (!currentTarget.contains(relatedTarget)) setOpen(false);
          }}
        >
          {groups
            .filter((group) => group.length > 0)
            .map((group, i) => (
              <div key={i} role="group" className="menu-group">
                {group.map((item) => (
                  <Item key={item.name} item={item} close={close} />
                ))}
              </div>
            ))}
        </div>
      )}
    </>
  );
}
