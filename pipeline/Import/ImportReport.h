// Reports an import: which layer became which channel, and how, with figures; what was left out and what is missing.
#pragma once

#include "Import/ImportConvert.h"

#include <string>

namespace Drydock
{

/** The data that a report is made of. */
struct FImportStory
{
	const FImportLayers& Layers;
	const FImportPlan& Plan;
	const FImportScene& Scene;
	const FImportChoices& Choices;
	const std::vector<FImportMatte>& Mattes;
};

/** A row's layer with its components: "FinalImageWorldNormal.RGB". */
DRYDOCK_API std::string DescribeSource(const FImportLayers& Layers, const FImportRow& Row);

/** Describes how a row's numbers are read: "cm along the axis", "0..1, Unreal's world". */
DRYDOCK_API std::string DescribeEncoding(const FImportRow& Row);

DRYDOCK_API std::string FormatImportTable(const FImportStory& Story, int Width = 0);

/** The same as an object: channels, leftOut, missing, objects, width and height. */
DRYDOCK_API std::string FormatImportJson(const FImportStory& Story);

} // namespace Drydock
