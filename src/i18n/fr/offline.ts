import type { OfflineTexts } from "../en/offline.ts";
import { typeset } from "./typography/typeset.ts";

export const offline: OfflineTexts = typeset({
  install: {
    install: "Installer",
    why: "Une fois installé, Turnwise a sa propre fenêtre et une icône sur cet appareil.",
    byHand: "Pour installer : Partager, puis « Sur l’écran d’accueil ».",
  },
  ready: "Une version plus récente de Turnwise est prête.",
  updateNow: "Mettre à jour",
  later: "Plus tard",
  elsewhere: "Turnwise a été mis à jour dans un autre onglet. Cet onglet garde sa version.",
  reload: "Recharger la page",
  look: "Rechercher des mises à jour",
  kept: {
    impossible: "Ce navigateur n’enregistre pas la page pour l’usage hors ligne ; il faut une adresse https.",
    coming: "Enregistrement de la page pour l’usage hors ligne …",
    kept: "Enregistrée sur cet appareil : fonctionne sans réseau.",
    failed: "La page n’est pas encore complète sur cet appareil. Le téléchargement continue dès que le réseau revient.",
  },
  looked: {
    no: "",
    looking: "Recherche de mises à jour …",
    coming: "Téléchargement d’une version plus récente …",
    newest: "C’est la version la plus récente.",
    unreachable: "Le serveur ne répond pas. Cette version continue de fonctionner.",
    unfinished: "La nouvelle version n’a pas été téléchargée en entier. Cette version reste en service.",
  },
});
