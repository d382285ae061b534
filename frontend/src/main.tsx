import "@mantine/core/styles/baseline.css";
import "@mantine/core/styles/default-css-variables.css";
import "@mantine/core/styles/global.css";
import "@mantine/core/styles/UnstyledButton.css";
import "@mantine/core/styles/CloseButton.css";
import "@mantine/core/styles/Paper.css";
import "@mantine/core/styles/Overlay.css";
import "@mantine/core/styles/ScrollArea.css";
import "@mantine/core/styles/ModalBase.css";
import "@mantine/core/styles/Modal.css";
import "@mantine/core/styles/Popover.css";
import "@mantine/core/styles/SegmentedControl.css";
import "@mantine/core/styles/FloatingIndicator.css";
import "./styles/tokens.css";
import "./styles/base.css";

import { MantineProvider } from "@mantine/core";
import { StrictMode } from "react";
import { createRoot } from "react-dom/client";
import { App } from "./App";
import { startLive } from "./api/live";
import { startSession } from "./api/session";
import { startShortcuts } from "./guidance/shortcuts";
import { preloadPages } from "./pages/laterPages";
import { startLanguage } from "./state/language";
import { startNotifications } from "./state/notifications";
import { unlockSound } from "./state/sounds";
import { startWakeLock } from "./state/wakeLock";
import { theme } from "./theme";

const root = document.getElementById("root");
if (!root) throw new Error("the page has no #root");

// it reads the address, before a link is removed from it
const language = startLanguage();
startLive();
void startSession();
// a link put into the address of a page that is open
window.addEventListener("hashchange", () => void startSession());
unlockSound();
startWakeLock();
startShortcuts();
startNotifications();
await language;
createRoot(root).render(
  <StrictMode>
    <MantineProvider theme={theme} defaultColorScheme="auto">
      <App />
    </MantineProvider>
  </StrictMode>,
);
// the first page has the line for itself
setTimeout(() => void preloadPages(), 3000);
