import type { OfflineTexts } from "../en/offline.ts";

export const offline = {
  install: {
    install: "Installieren",
    why: "Installiert hat Turnwise ein eigenes Fenster und ein Symbol auf diesem Gerät.",
    byHand: "Installieren: Teilen, dann „Zum Home-Bildschirm“.",
  },
  ready: "Eine neuere Version von Turnwise ist bereit.",
  updateNow: "Jetzt aktualisieren",
  later: "Später",
  elsewhere: "Turnwise wurde in einem anderen Tab aktualisiert. Dieser Tab behält seine Version.",
  reload: "Seite neu laden",
  look: "Nach Updates suchen",
  kept: {
    impossible: "Dieser Browser speichert die Seite nicht für den Offline-Betrieb; dazu ist eine https-Adresse nötig.",
    coming: "Seite wird für den Offline-Betrieb gespeichert …",
    kept: "Auf diesem Gerät gespeichert: läuft ohne Netz.",
    failed: "Die Seite ist noch nicht vollständig gespeichert. Der Download wird fortgesetzt, sobald ein Netz da ist.",
  },
  looked: {
    no: "",
    looking: "Suche nach Updates …",
    coming: "Neuere Version wird heruntergeladen …",
    newest: "Das ist die neueste Version.",
    unreachable: "Der Server antwortet nicht. Diese Version läuft weiter.",
    unfinished: "Die neuere Version wurde nicht vollständig heruntergeladen. Diese Version bleibt aktiv.",
  },
} satisfies OfflineTexts;
