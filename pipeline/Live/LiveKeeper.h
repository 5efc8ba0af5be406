// Two processes: one keeps the other, which runs the frames, and starts it again when the code of a plugin has crashed
// it. State that outlives a crash lies in files of a folder that both know.
#pragma once

#include "Live/EditHistory.h"

#include <optional>
#include <string>

namespace Drydock
{

/** The kept one's view of the folder. */
class DRYDOCK_API FLiveKeep
{
public:
	explicit FLiveKeep(std::string InFolder);

	/** Address of the server that crashed; nothing: this is the first. */
	struct FDoor
	{
		int Port = 0;
		std::string Token;
	};
	std::optional<FDoor> ReadDoor() const;
	void WriteDoor(const FDoor& Door) const;

	/** The state of the last frame that was well; nothing: this is the first, or there was none. */
	std::optional<FEditHistory> ReadHistory() const;

	/** The last line that the crash left on stderr; empty: there was none. */
	std::string ReadCrash() const;

	/** A frame of this state was well. */
	void Write(const FEditHistory& History) const;

private:
	std::string GetFile(const char* Name) const { return Folder + "/" + Name; }

	const std::string Folder;
};

/** The folder's name in the environment; null: this process is the one that keeps. */
const char* FindLiveFolder();

/** Runs this program again with the same arguments, and once more after each crash that came after a frame which was
 * well. Returns its exit code. Throws FError where it cannot be started. */
int KeepLive();

} // namespace Drydock
