// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The page of `gudgeon report`: fills the places that the program left in it.
import 'uplot/dist/uPlot.min.css';
import './style.css';
import { make } from './elements.js';
import { fillFigurePlaces } from './figure_places.js';
import { fillMechanismPlaces } from './mechanism_panel.js';
import { startTheme } from './palette.js';

/** Links to the sections that are shown. */
function showSections() {
  const sections = [...document.querySelectorAll('main section')].filter((section) => !section.closest('[hidden]'));
  document.getElementById('sections').replaceChildren(...sections.map((section) =>
    make('a', { href: `#${section.id}`, title: section.querySelector('h2').textContent }, section.dataset.brief)));
}

/** Of several cases one is shown. */
function startCases() {
  const choice = document.getElementById('case-choice');
  if (!choice) return;
  const show = () => {
    for (const article of document.querySelectorAll('article.case')) article.hidden = article.dataset.case !== choice.value;
    showSections();
  };
  choice.addEventListener('change', show);
  show();
}

startTheme(document.getElementById('theme'));
fillFigurePlaces();
fillMechanismPlaces();
startCases();
showSections();
document.documentElement.dataset.ready = 'true';
