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

	/** The state that this makes, which Take then takes. Each throws FError (DD1120) where it cannot be. */
	std::string Edit(const std::vector<FConfigEdit>& Edits) const;
	std::string Undo() const;
	std::string Redo() const;
	/** Pointer: one place back to what it was at the start; empty: all. */
	std::string Reset(const std::optional<std::string>& Pointer) const;

	enum class EMove
	{
		Forward, // a new step
		Undo,
		Redo,
	};

	/** The name of a drag that sets these places; empty: it is none. Id: as the page names it, or empty. */
	static std::string MakeDrag(const std::string& Id, const std::vector<FConfigEdit>& Edits);

	/** Line: JSON, for the record. Steps of one drag that follow each other are one step, and one line. After 64 MB
	 * only the start and this state remain, in the record too. */
	void Take(const std::string& Text, EMove Move, const std::string& Line, const std::string& Drag = "");

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
