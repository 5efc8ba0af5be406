// The archive that the engine saves objects to and loads them from: nothing is saved here, and nobody makes one.
// Source: engine Serialization/Archive.h.
#pragma once

class FArchive
{
public:
	bool IsLoading() const { return false; }
	bool IsSaving() const { return false; }
	template<typename T>
	FArchive& operator<<(T&)
	{
		return *this;
	}
};
