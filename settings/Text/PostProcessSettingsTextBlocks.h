// The engine's text of copied actors as a tree of blocks: Begin Actor Class=.. Name=.. to End Actor, with the
// properties that volumes need. Other lines are skipped: they are for the editor. Source: engine text of copied actors;
// drydock.
#pragma once

#include "PostProcessSettingsTextTree.h"

#include <string>
#include <vector>

namespace Drydock
{

struct FEngineTextBlock
{
	std::string Kind;  // "Actor", "Object", "Map"; empty for what stands outside all blocks
	std::string Class; // without its package: "PostProcessVolume"; empty where it is not written
	std::string Name;
	std::vector<FEngineTextItem> Properties; // those of GetVolumeProperties
	std::vector<FEngineTextBlock> Blocks;
	std::vector<double> Vertices; // X, Y, Z of every corner of a brush's polygons
	size_t Offset = 0;            // of Begin

	/** Null when it has no such property. */
	DRYDOCK_API const FEngineTextItem* Find(const char* Property) const;
};

/** Reads a whole text. Every error is reported; what can be read is returned. */
DRYDOCK_API FEngineTextBlock ParseEngineTextBlocks(const std::string& Text, FSettingsTextMessages& Messages);

} // namespace Drydock
