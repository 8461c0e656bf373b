import type { OfflineTexts } from "../en/offline.ts";

export const offline = {
  ready: "Eine neuere Version von Turnwise ist bereit.",
  updateNow: "Jetzt aktualisieren",
  later: "Später",
  elsewhere: "Turnwise wurde in einem anderen Tab aktualisiert. Dieser arbeitet mit seiner Version weiter.",
  reload: "Seite neu laden",
  look: "Neuere Version suchen",
  kept: {
    impossible:
      "Dieser Browser behält die Seite nicht für den Betrieb ohne Netz; dazu braucht es eine Adresse mit https.",
    coming: "Die Seite wird auf diesem Gerät abgelegt, für den Betrieb ohne Netz.",
    kept: "Auf diesem Gerät abgelegt: läuft ohne Netz.",
    failed: "Die Seite liegt noch nicht ganz auf diesem Gerät. Sobald ein Netz da ist, geht es weiter.",
  },
  looked: {
    no: "",
    looking: "Neuere Version wird gesucht.",
    coming: "Eine neuere Version wird geholt.",
    newest: "Das ist die neueste Version.",
    unreachable: "Der Server antwortet nicht. Was hier ist, läuft weiter.",
    unfinished: "Die neuere Version kam nicht vollständig an. Diese bleibt in Gebrauch.",
  },
} satisfies OfflineTexts;
