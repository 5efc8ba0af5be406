// Shows a bar on stderr while passes run; nothing when stderr is not a terminal.
#pragma once

#include "DrydockAPI.h"
#include "Templates/UnrealTemplate.h"

#include <string>

namespace Drydock
{

class FProgressBar : private FNoncopyable
{
public:
	FProgressBar();
	~FProgressBar() { Clear(); }

	void Show(int Done, int Total, const std::string& What);
	void Clear();

private:
	bool bTerminal;
	bool bShown = false;
};

/** "2.5 frames/s, 3 min 20 s left": of Done things in so many seconds, with NumLeft to go. Empty until one is done. */
DRYDOCK_API std::string DescribeRate(int Done, int NumLeft, double Seconds);

/** Whether text on that file descriptor may be coloured: a terminal, and NO_COLOR is not set. */
bool IsColorful(int FileDescriptor);

} // namespace Drydock
