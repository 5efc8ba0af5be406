// The states of a session: texts of a config, by which edits are undone and done again, and the record of it all.
#pragma once

#include "Live/ConfigText.h"

namespace Drydock
{

class DRYDOCK_API FEditHistory
{
public:
	/** File: of the config, for the record. Start: its text. */
	FEditHistory(std::string InFile, std::string Start);

	const std::string& GetFile() const { return File; }
	const std::string& GetText() const { return Steps[Now].Text; }
	const std::string& GetStart() const { return Steps.front().Text; }
	bool CanUndo() const { return Now > 0; }
	bool CanRedo() const { return Now + 1 < Steps.size(); }

	/** Grows with every change of the state. */
	uint64_t GetRevision() const { return Revision; }

	/** A state that is not taken yet. */
	struct FNext
	{
		std::string Text;
		size_t Step = 0;       // its place among the states
		std::string Line = {}; // of the record
		std::string Drag = {}; // the places that a drag sets, and its name; empty: it is none
		bool bForward = true;  // states behind the place go
	};

	/** The state that a change makes: {"edits": [...], "drag": NAME}, {"undo": true}, {"redo": true}, {"reset": PLACE}
	 * back to the start, all of it without a place, or {"text": CONFIG}. The drag is optional. Throws FError (DD1120)
	 * where it cannot be. */
	FNext Plan(const FJsonValue& Change) const;

	/** Steps of one drag that follow each other are one step, and one line of the record. After 64 MB only the start
	 * and this state remain, in the record too. */
	void Take(const FNext& Next);

	/** Something beside the text has changed. */
	void TakeChange() { ++Revision; }

	/** The record: JSON lines, which Replay takes. */
	std::string GetRecord() const;

	/** The history that the record tells. RecordFile: its name in messages. Throws FError (DD1122). */
	static FEditHistory Replay(const std::string& Record, const std::string& RecordFile);

private:
	struct FStep
	{
		std::string Text;
		std::string Drag;
	};

	/** The text with one place as it was at the start. */
	std::string Reset(const std::string& Pointer) const;

	std::string File;
	std::vector<FStep> Steps;
	size_t Now = 0;
	uint64_t Revision = 1;
	std::string First;              // line of the record
	std::vector<std::string> Lines; // of the record, behind it
	std::string LastDrag;           // of the last line
	size_t NumBytes = 0;            // that were added
};

} // namespace Drydock
