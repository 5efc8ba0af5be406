// A folder of code to be run. It is opened once; its owner and mode, and those of all that is taken from it, are
// checked on what was opened, and nothing is reached by its path again: what is used is what was checked.
#pragma once

#include "DrydockAPI.h"
#include "FileDescriptor.h"

#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace Drydock
{

enum class ETrust
{
	Trusted,
	Foreign, // another user's, writable by others, a symbolic link, or nothing of the kind
	Absent,  // not there, or not to be opened
};

/** A file of a folder, and where it cannot be used, why. */
struct FTrustedFile
{
	ETrust Trust = ETrust::Absent;
	std::string Fault;    // "belongs to another user (uid 1001)"; empty where it is trusted
	FFileDescriptor File; // none where it is not trusted
};

/** Files that are written together: all of them, or none. Name: "costs.json", or one folder deep, "ab/entry.so". */
struct FFileToWrite
{
	std::string Name;
	std::string Bytes;
};

class DRYDOCK_API FTrustedFolder
{
public:
	/** Owners: the users that may have made it and what is in it. No one else may be able to write to either. */
	FTrustedFolder(const std::string& InPath, const std::vector<uid_t>& InOwners);

	/** Makes a folder that only the user can look into (0700), and what is missing above it as usual. One that is there
	 * stays as it is. 0, or the error. */
	static int Make(const std::string& Path);

	const std::string& GetPath() const { return Path; }
	ETrust GetTrust() const { return Folder.Trust; }
	/** Fault of the folder: see FTrustedFile. */
	const std::string& GetFault() const { return Folder.Fault; }
	/** 0, or why nothing can be written to it. */
	int FindWriteError() const;

	/** Open for reading. */
	FTrustedFile Open(const std::string& Name) const;
	/** Open for reading and writing, made where it is not there. */
	FTrustedFile OpenOrMake(const std::string& Name) const;

	/** Names of what lies in a folder of this one. */
	std::vector<std::string> List(const std::string& Subfolder) const;

	/** Writes aside and renames, in the given order, once all are written. 0, or the error. */
	int Write(const std::vector<FFileToWrite>& Files) const;

	/** A path that leads into this very folder as long as the object lives, whatever becomes of the folders above. */
	std::string GetLoadPath(const std::string& Name) const;

private:
	FTrustedFile OpenSubfolder(const std::string& Subfolder) const;
	FTrustedFile OpenIn(const FTrustedFile& In, const std::string& Name, int Flags) const;
	FTrustedFile OpenByName(const std::string& Name, int Flags) const;

	std::string Path;
	std::vector<uid_t> Owners;
	FTrustedFile Folder;
};

} // namespace Drydock
